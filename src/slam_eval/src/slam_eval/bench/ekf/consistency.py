# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part consistency: NEES over a simulated loop, averaged over seeds; other back-ends beside the EKF."""
import json

import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import Section, number, table, verdict
from slam_eval.metrics.chi_square import two_sided_bounds
from slam_eval.plot.benchmarks import plot_average_nees

LOOPS = (60, 120)  # [m]
FIRST_STEP = 20    # the map is young before, and NEES says little
POSE_DOF = 3

INSIDE_LIMIT = 0.90
NIS_LIMITS = (0.95, 1.05)
UNSCENTED_LOOP = 120                             # [m], on which the unscented filter has goals
UNSCENTED_INSIDE, UNSCENTED_SLOWER = 0.75, 3.0   # in bounds; step over the extended filter's
SPARSE_NEES = 3.6                                # largest mean NEES of the back-end seif
LINEARIZATIONS = ("right_invariant", "observability_constrained", "first_estimates", "textbook")
DEFAULT = LINEARIZATIONS[0]
FILTERS = ("extended", "unscented")
OTHERS = ("seif", "graph")  # back-ends
LINEAR_SCALE = 0.01  # of all noise: nothing is left to linearise

HEADER = ["loop", "steps", "in bounds", "mean NEES", "NIS/dof", "position rmse [m]", "step [us]"]


def bounds(seeds, probability=0.95):
    """Bounds of the average over seeds of a NEES of three degrees of freedom."""
    low, high = two_sided_bounds(POSE_DOF * seeds, probability)
    return low / seeds, high / seeds


def summary(result):
    """(share of steps inside the bounds, mean NEES), both after the first steps."""
    values = np.array(result["average_nees"][FIRST_STEP:])
    if not len(values) or not np.all(np.isfinite(values)):
        raise BenchError("slam_eval_consistency printed no finite NEES after step "
                         f"{FIRST_STEP}; the filter failed on this case")
    low, high = bounds(result["seeds"])
    return float(np.mean((values >= low) & (values <= high))), float(np.mean(values))


def variants():
    """(name, filter, linearisation) of all that are compared; the default's name is DEFAULT."""
    return [(linearization if of == FILTERS[0] else f"{of}, {linearization}", of, linearization)
            for of in FILTERS for linearization in LINEARIZATIONS]


def run_backend(context, loop, name, backend, settings=(), noise=1.0):
    """What slam_eval_consistency says of a back-end on a loop [m], whose start is known exactly."""
    log = context.work / f"consistency_{loop}_{name.replace(', ', '_')}_{noise:g}.json"
    seeds = context.options.seeds
    exact = [f"{backend}.initial_sigma_{of}=1e-6" for of in ("position", "heading")]
    command = [workspace_program("slam_eval", "slam_eval_consistency"), "--backend", backend,
               "--loop", str(loop), "--seeds", str(seeds), "--noise", str(noise),
               "--set", *settings, *exact]
    call(context, f"consistency, loop of {loop} m, {name}, {seeds} seeds", command, log)
    try:
        return json.loads(log.read_text(encoding="utf-8"))
    except json.JSONDecodeError:
        raise BenchError("slam_eval_consistency printed no JSON; build it again") from None


def run_loop(context, loop, filter_name, linearization, noise=1.0):
    """The same of a variant of the EKF."""
    return run_backend(context, loop, f"{filter_name}, {linearization}", "ekf",
                       [f"ekf.filter={filter_name}", f"ekf.linearization={linearization}"], noise)


def row(name, result):
    """A line of the table."""
    inside, nees = summary(result)
    return [name, number(len(result["average_nees"]), "d"), number(inside, ".1%"),
            number(nees, ".2f"), number(result["nis_mean"], ".3f"),
            number(result["position_rmse_m"], ".3f"), number(1e3 * result["step_ms"], ".1f")]


def remark(loop, result):
    """Whether the default keeps to its goals on this loop."""
    inside, _ = summary(result)
    nis = result["nis_mean"]
    kept = "reached" if NIS_LIMITS[0] <= nis <= NIS_LIMITS[1] else "MISSED"
    told = verdict(inside, INSIDE_LIMIT, False)
    return (f"{loop} m, {DEFAULT}: in bounds {inside:.1%} ({told}), "
            f"NIS/dof {nis:.3f} ({NIS_LIMITS[0]:g} to {NIS_LIMITS[1]:g}: {kept})")


def unscented_remark(loop, extended, unscented):
    """Whether sigma points are as good as they should be, and at which price."""
    inside, _ = summary(unscented)
    slower = unscented["step_ms"] / extended["step_ms"]
    return (f"{loop} m, unscented, {DEFAULT}: in bounds {inside:.1%} "
            f"({verdict(inside, UNSCENTED_INSIDE, False)}), step {slower:.2f} times the extended "
            f"filter's ({verdict(slower, UNSCENTED_SLOWER, True)})")


def sparse_remark(loop, result):
    """Whether the sparse information filter is as consistent as it should be."""
    _, nees = summary(result)
    return f"{loop} m, seif: mean NEES {nees:.2f} ({verdict(nees, SPARSE_NEES, True)})"


def measure(context):
    """The section of this part."""
    low, high = bounds(context.options.seeds)
    section = Section("Consistency: a simulated loop")
    lines, remarks = [], []
    for loop in LOOPS:
        results = {name: run_loop(context, loop, *of) for name, *of in variants()}
        linear = run_loop(context, loop, FILTERS[0], DEFAULT, LINEAR_SCALE)
        others = {f"back-end {name}": run_backend(context, loop, name, name) for name in OTHERS}
        lines += [row(f"{loop} m, {name}", result) for name, result in (results | others).items()]
        lines.append(row(f"{loop} m, {DEFAULT}, noise x {LINEAR_SCALE:g}", linear))
        remarks += [remark(loop, results[DEFAULT]),
                    sparse_remark(loop, others["back-end seif"])]
        if loop == UNSCENTED_LOOP:
            unscented = results[f"unscented, {DEFAULT}"]
            remarks.append(unscented_remark(loop, results[DEFAULT], unscented))
        path = context.out / f"consistency_nees_{loop}.png"
        plot_average_nees(results, (low, high), f"NEES over a loop of {loop} m", path)
        section.pictures[f"average NEES over a loop of {loop} m"] = path
    section.paragraphs += [
        table(HEADER, lines), "; ".join(remarks) + ".",
        f'Three laps past 20 landmarks, {context.options.seeds} seeds. "In bounds": share of the '
        f"steps after the first {FIRST_STEP} whose NEES, averaged over the seeds, lies inside its "
        f"95 % bounds ({low:.2f} to {high:.2f}; 3 and 1 are expected of NEES and NIS/dof). With "
        f"{LINEAR_SCALE:g} of the noise any linearisation is as good as exact: that line is "
        "what these seeds show of a perfect filter. Step: CPU time with the reported pose."]
    return section
