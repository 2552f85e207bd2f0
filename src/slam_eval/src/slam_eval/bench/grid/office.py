# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part office of benchmark grid: the grid product in the simulated office."""
import dataclasses

from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.products import PF_WHEEL_GRID
from slam_eval.bench.harness.programs import simulation_file
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, mean_row, Section, table
from slam_eval.io.run_folder import read_run
from slam_eval.io.world_plan import read_world
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.map_agreement import judge_map
from slam_eval.plot.map import plot_map

SENSORS = "odom,scan,camera"

HEADER = ["seed", "ATE [m]", "NEES", "cells on walls [%]", "walls found [%]", "CPU [s]",
          "memory [MB]"]
FORMS = [".4f", ".2f", ".1f", ".1f", ".1f", ".0f"]
GOALS = (Goal("cells on walls [%]", 95.0, False), Goal("walls found [%]", 90.0, False))


@dataclasses.dataclass(frozen=True)
class OfficeCase:
    """What the product sees of the office, and how far it may be off."""

    name: str
    detector: str
    ate: float  # [m]

    @property
    def goals(self):
        """The limits of its table."""
        return (Goal("ATE [m]", self.ate), *GOALS)


CASES = (OfficeCase("laser alone", "none", 0.06),
         OfficeCase("laser and landmarks", "apriltag", 0.03))


def _seed_line(context, case, seed, section):
    name = f"grid_office_{seed}"
    bag = simulate(context, name, "office", seed, SENSORS)
    folder, usage = run_ours(context, f"{name}_{case.detector}", bag, product=PF_WHEEL_GRID,
                             settings=(f"detector={case.detector}",))
    run, path = read_run(folder), simulation_file("worlds", "office")
    world = read_world(path)
    result = evaluate(run, agreement=judge_map(run, world, path))
    if seed == 1:
        picture = context.out / f"grid_office_{case.detector}.png"
        section.pictures[f"map of the office, {case.name}, seed 1"] = picture
        plot_map(run, result, picture, world=world)
    m = result.metrics
    return [str(seed), m.get("ate_rmse_m"), m.get("nees_mean"),
            m.get("map_cells_on_walls_percent"), m.get("map_walls_found_percent"), usage.cpu_s,
            usage.max_rss_mb]


def measure(context):
    """The section of part office."""
    section = Section("Simulated office")
    for case in CASES:
        rows = [_seed_line(context, case, seed, section)
                for seed in range(1, context.options.drives + 1)]
        section.paragraphs += [
            f"{case.name.capitalize()}:",
            table(HEADER, lines_of([*rows, mean_row("mean", rows)], FORMS)),
            verdicts(case.goals, HEADER, rows)]
    section.paragraphs.append(
        "Cells on walls and walls found: within one cell, the map moved onto the truth by a rigid "
        "fit of its path. NEES: 3 expected, less is cautious. CPU time includes the detection of "
        "landmarks.")
    return section
