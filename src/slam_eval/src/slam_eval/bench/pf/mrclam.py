# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part mrclam of benchmark pf: the five robots of a MRCLAM set, several seeds, beside the EKF."""
import dataclasses

import numpy as np

from slam_eval.bench.harness.mrclam import find_data, import_robot, ROBOTS
from slam_eval.bench.harness.runs import run_ours
from slam_eval.bench.harness.table import lines_of, Section, table, verdict
from slam_eval.bench.pf.variants import (DEFAULT, EKF, FEW, MANY, OTHER_EKFS,
                                         few_verdict)
from slam_eval.io.run_folder import read_run
from slam_eval.io.trajectory import read_trajectory
from slam_eval.metrics.evaluation import evaluate

ATE_LIMIT, LANDMARK_LIMIT, EKF_SHARE = 0.30, 0.13, 1.1

HEADER = ["filter", "ATE [m]", "worst run [m]", "landmarks [m]", "final path [m]", "NEES",
          "NIS/dof", "CPU a run [s]"]
FORMS = [".3f", ".3f", ".3f", ".3f", ".1f", ".3f", ".2f"]


def _final_error(folder, run):
    """ATE of the path as the best particle sees it at the end."""
    final = dataclasses.replace(run, trajectory=read_trajectory(folder / "trajectory_final.tum"))
    return evaluate(final).metrics.get("ate_rmse_m")


def run_variant(context, variant, bags):
    """The figures of all robots and seeds: a line each."""
    rows = []
    for robot, bag in bags.items():
        for seed in range(1, context.options.seeds + 1 if variant.random else 2):
            name = variant.run_name(f"robot{robot}_{seed}")
            folder, usage = run_ours(context, name, bag, "mrclam", variant.product,
                                     (*variant.settings, f"seed={seed}"))
            run = read_run(folder)
            m = evaluate(run).metrics
            rows.append([m["ate_rmse_m"], m["landmark_rmse_m"], _final_error(folder, run),
                         m["nees_mean"], m["nis_mean"], usage.cpu_s])
    return np.array(rows, dtype=float)


def summary(rows):
    """The numbers of a variant's line: means over all runs, and the worst trajectory error."""
    mean = rows.mean(axis=0)
    return [mean[0], rows[:, 0].max(), *mean[1:]]


def verdicts(of):
    """A line for each goal."""
    ekf, default, few, many = (of[v.name] for v in (EKF, DEFAULT, FEW, MANY))
    goals = (("mean ATE", default[0], ATE_LIMIT),
             ("mean ATE over that of the EKF", default[0] / ekf[0], EKF_SHARE),
             ("mean landmark RMSE", default[2], LANDMARK_LIMIT))
    lines = [f"- {what} {value:.3f} ({verdict(value, limit, True)})"
             for what, value, limit in goals]
    return "\n".join([*lines, few_verdict(few[0], many[0])])


def measure(context):
    """The section of this part."""
    section = Section("Accuracy: MRCLAM")
    data = find_data(context.options, section)
    if data is None:
        return section
    bags = {robot: import_robot(context, data, robot) for robot in ROBOTS}
    of = {variant.name: summary(run_variant(context, variant, bags))
          for variant in (EKF, *OTHER_EKFS, DEFAULT, FEW, MANY)}
    lines = lines_of([[name, *figures] for name, figures in of.items()], FORMS)
    section.paragraphs += [table(HEADER, lines), verdicts(of),
                           f"{data.name}: means over five robots and "
                           f"{context.options.seeds} seeds, errors after a rigid alignment."]
    return section
