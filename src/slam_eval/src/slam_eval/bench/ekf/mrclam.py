# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part mrclam: the five robots of a MRCLAM set with one configuration."""
import dataclasses
from typing import Optional

import numpy as np

from slam_eval.bench.harness.mrclam import find_data, import_robot, ROBOTS
from slam_eval.bench.harness.runs import run_ours
from slam_eval.bench.harness.table import lines_of, mean_row, Section, table, verdict
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate, inside_bounds
from slam_eval.plot.benchmarks import plot_trajectories

ATE_LIMIT, LANDMARK_LIMIT = 0.25, 0.09  # [m]

HEADER = ["robot", "ATE [m]", "landmarks [m]", "dead reckoning [m]", "NEES", "in bounds",
          "NIS/dof", "updates", "wall [s]", "CPU [s]", "memory [MB]"]
FORMS = [".3f", ".3f", ".3f", ".2f", ".1%", ".3f", ".0f", ".2f", ".2f", ".1f"]


@dataclasses.dataclass
class Robot:
    """A robot's run with its evaluation and cost."""

    name: str
    run: object
    result: object
    usage: object

    @property
    def inside(self) -> Optional[float]:
        """Share of the steps whose NEES lies inside its 95 % bounds."""
        pose = self.result.consistency
        if pose is None:
            return None
        return float(np.mean(inside_bounds(pose.nees, np.full(len(pose.nees), 3))))

    def values(self):
        """The numbers of a line of the table."""
        m, u = self.result.metrics, self.usage
        return [self.name, m.get("ate_rmse_m"), m.get("landmark_rmse_m"),
                m.get("odometry_ate_rmse_m"), m.get("nees_mean"), self.inside, m.get("nis_mean"),
                len(self.run.trajectory), u.wall_s, u.cpu_s, u.max_rss_mb]


def run_robot(context, data, robot):
    """Import, run and evaluate one robot."""
    name = f"robot{robot}"
    bag = import_robot(context, data, robot)
    folder, usage = run_ours(context, name, bag, "mrclam")
    run = read_run(folder)
    return Robot(str(robot), run, evaluate(run), usage)


def measure(context):
    """The section of this part."""
    section = Section("Accuracy: MRCLAM")
    data = find_data(context.options, section)
    if data is None:
        return section
    robots = [run_robot(context, data, robot) for robot in ROBOTS]
    values = [robot.values() for robot in robots]
    mean = mean_row("mean", values)
    remarks = [f"{what} {value:.3f} m ({verdict(value, limit, True)})" for what, value, limit in (
        ("mean ATE", mean[1], ATE_LIMIT), ("mean landmark RMSE", mean[2], LANDMARK_LIMIT))
        if value is not None]
    section.paragraphs += [table(HEADER, lines_of([*values, mean], FORMS)),
                           f"{data.name}: " + "; ".join(remarks)
                           + '. Errors after a rigid alignment; "in bounds" is the share of steps '
                           "whose NEES lies inside its 95 % bounds. Import not counted."]
    path = context.out / "mrclam_trajectories.png"
    plot_trajectories(robots, path)
    section.pictures["trajectories of the MRCLAM robots"] = path
    return section
