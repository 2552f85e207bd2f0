# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part commands: the EKF on a robot's commands beside that on its wheels, over simulated drives."""
from slam_eval.bench.harness.products import EKF_WHEEL, SENSORS
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, mean_row, Section, table
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate

WORLDS = ("office", "foyer")
ROBOTS = {"office": "segway", "foyer": "scout"}
DRIVES = 3
PRODUCTS = (EKF_WHEEL, "ekf_command")
FIGURES = ("odometry_ate_rmse_m", "ate_rmse_m", "nees_mean", "confidently_wrong_s")

HEADER = ["world and product", "dead reckoning [m]", "ATE [m]", "NEES", "confidently wrong [s]"]
FORMS = [".3f", ".4f", ".2f", ".1f"]


def row_of(world, product, drives):
    """The line of a product: means over the drives' metrics."""
    name = f"{world}, {product}"
    return mean_row(name, [[name, *(drive.get(figure) for figure in FIGURES)] for drive in drives])


def _drive(context, world, product, seed, bag):
    folder, _ = run_ours(context, f"commands_{world}_{product}_{seed}", bag, product=product)
    return evaluate(read_run(folder)).metrics


def measure(context):
    """The section of this part."""
    rows = []
    for world in WORLDS:
        bags = {seed: simulate(context, f"commands_{world}_{seed}", world, seed,
                               f"{SENSORS},commands", robot=ROBOTS[world])
                for seed in range(1, DRIVES + 1)}
        rows += [row_of(world, product, [_drive(context, world, product, *entry)
                                         for entry in bags.items()]) for product in PRODUCTS]
    section = Section("Wheels and commands")
    section.paragraphs += [
        table(HEADER, lines_of(rows, FORMS)),
        f"Means over {DRIVES} simulated drives. The base follows its commands with a lag of 0.15 s, "
        "2 % too slow, turns 3 % too far, and errs by 5 % of each; the robot files say nothing of "
        "that. NEES: 3 is expected of the pose, less is cautious."]
    return section
