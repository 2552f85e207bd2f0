# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part office of benchmark pf: the filters on simulated drives of many seeds."""
from slam_eval.bench.harness.products import SENSORS
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, Section, table, verdict
from slam_eval.bench.pf.variants import DEFAULT, FEW, MANY, few_verdict
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate

ATE_LIMIT = 0.03

HEADER = ["filter", "ATE [m]", "worst run [m]", "landmarks [m]", "fewest mapped", "of", "NIS/dof",
          "CPU a run [s]"]
FORMS = [".4f", ".4f", ".4f", "g", "g", ".3f", ".1f"]


def _row(folder, usage):
    """ATE, landmark RMSE, markers mapped, markers there are, NIS/dof and CPU time of a run."""
    run = read_run(folder)
    metrics = evaluate(run).metrics
    true = set(run.true_landmarks.ids)
    mapped = set(run.landmarks.ids) if run.landmarks is not None else set()
    return [metrics["ate_rmse_m"], metrics.get("landmark_rmse_m"), len(mapped & true), len(true),
            metrics.get("nis_mean"), usage.cpu_s]


def run_drive(context, seed, variants):
    """Simulate a drive and run the variants on it: {name: row}."""
    bag = simulate(context, f"office_{seed}", "office", seed, SENSORS)
    rows = {}
    for variant in variants:
        folder, usage = run_ours(context, variant.run_name(f"office_{seed}"), bag,
                                 product=variant.product,
                                 settings=(*variant.settings, f"seed={seed}"))
        rows[variant.name] = _row(folder, usage)
    if context.options.keep is None:
        bag.unlink()
    return rows


def summary(rows):
    """The numbers of a variant's line: means over the drives, the worst error, fewest markers."""
    ate, landmarks, mapped, of, nis, cpu = zip(*rows)

    def mean(values):
        return None if None in values else sum(values) / len(values)
    return [mean(ate), max(ate), mean(landmarks), min(mapped), of[0], mean(nis), mean(cpu)]


def verdicts(of):
    """A line for each goal."""
    _, worst, _, mapped, there, *_ = of[DEFAULT.name]
    name = DEFAULT.name
    return "\n".join([
        f"- {name}: worst ATE {worst:.4f} ({verdict(worst, ATE_LIMIT, True)})",
        f"- {name}: fewest markers mapped {mapped} ({verdict(mapped, there, False)})",
        few_verdict(of[FEW.name][0], of[MANY.name][0])])


def measure(context):
    """The section of this part."""
    variants = (DEFAULT, FEW, MANY)
    drives = [run_drive(context, seed, variants)
              for seed in range(1, context.options.drives + 1)]
    of = {v.name: summary([drive[v.name] for drive in drives]) for v in variants}
    section = Section("Accuracy: the simulated office")
    lines = lines_of([[name, *figures] for name, figures in of.items()], FORMS)
    section.paragraphs += [table(HEADER, lines), verdicts(of),
                           f"Means over {len(drives)} drives of other seeds, detection of the "
                           "markers included; errors after a rigid alignment."]
    return section
