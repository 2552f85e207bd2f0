# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A system that believes its odometry: the least that a driver has to do."""
import pathlib

from slam_eval.foreign.bag_data import read_odometry
from slam_eval.foreign.driver import Driver
from slam_eval.foreign.results import write_about, write_trajectory


class DeadReckoning(Driver):
    numbers = ("scale",)

    def programs(self):
        return [pathlib.Path(__file__)]

    def run(self, job):
        odometry = read_odometry(job.bag)
        odometry.poses[:, 0] *= self.number("scale")
        write_trajectory(job.folder / "trajectory.tum", odometry)
        write_about(job, "dead_reckoning", "", None, len(odometry))
