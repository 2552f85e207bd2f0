# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""MRPT's kf-slam as a foreign system."""
import math

import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.peers.mrpt_config import kf_slam_ini, scene_name
from slam_eval.foreign.bag_data import (
    has_topic, read_observations, read_odometry, robot_of)
from slam_eval.foreign.driver import Driver
from slam_eval.foreign.mrpt import program
from slam_eval.foreign.mrpt_rawlog import MotionNoise, write_rawlog
from slam_eval.foreign.results import write_about, write_landmarks, write_trajectory
from slam_eval.geometry import se2
from slam_eval.io.mrpt_files import read_kf_slam_map
from slam_eval.io.trajectory import interpolate, Trajectory

_SIGMAS = ("range_sigma", "bearing_sigma_deg")  # [m], [deg]; both or none are set


class MrptKf(Driver):
    """An EKF with landmarks whose ids are known; its trajectory.tum holds the pose after each array
    of observations."""

    required = ("detector_product",)
    not_negative = ("motion_sigma_per_metre", "motion_sigma_per_radian",
                    "motion_sigma_deg_per_metre", "motion_sigma", "motion_sigma_deg")
    positive = optional = _SIGMAS

    def programs(self):
        return [program("kf-slam"), workspace_program("slam_eval", "slam_eval_observations")]

    def _observations(self, job):
        """What is seen in the bag: its own observations, or those of our detector."""
        if has_topic(job.bag, "observations"):
            return read_observations(job.bag)
        seen = job.folder / "observations.bag"
        job.call([workspace_program("slam_eval", "slam_eval_observations"),
                  self.parameters["detector_product"], job.bag, seen], job.folder / "detector.txt")
        try:
            return read_observations(seen)
        finally:
            seen.unlink()

    def _sigmas(self, seen):
        """Standard deviations of range [m] and bearing [rad]: those that are set, else the medians
        of what the observations claim, for kf-slam knows one for all."""
        claimed = [pair for each in seen for pair in each.sigmas]
        given = tuple(self.parameters.get(name) for name in _SIGMAS)
        if given == (None, None) and claimed:
            return tuple(float(sigma) for sigma in np.median(claimed, axis=0))
        if given == (None, None):
            raise BenchError("the observations claim no standard deviations; set range_sigma and "
                             "bearing_sigma_deg")
        if None in given:
            lacking, there = _SIGMAS if given[0] is None else reversed(_SIGMAS)
            raise BenchError(f"{there} is set and {lacking} is not; set both, or neither where the "
                             "observations claim them")
        return self.number("range_sigma"), math.radians(self.number("bearing_sigma_deg"))

    def _noise(self):
        heading_by_way = math.radians(self.number("motion_sigma_deg_per_metre"))
        return MotionNoise(self.number("motion_sigma_per_metre"), 0.0, heading_by_way,
                           self.number("motion_sigma_per_radian"), self.number("motion_sigma"),
                           math.radians(self.number("motion_sigma_deg")))

    def _write_rawlog(self, job, odometry, seen, sigmas):
        increments = [se2.compose(se2.inverse(a), b) for a, b in
                      zip(np.vstack([odometry.poses[:1], odometry.poses[:-1]]), odometry.poses)]
        write_rawlog(job.folder / "bag.rawlog", increments, seen, self._noise(), sigmas)

    def _call(self, job, sigmas):
        """Runs kf-slam, which writes the pose of each step."""
        ini = kf_slam_ini(1, sigmas[0], math.degrees(sigmas[1]))
        (job.folder / "kf-slam.ini").write_text(
            ini.replace("logOutput_dir = map", f"logOutput_dir = {job.folder / 'map'}"),
            encoding="utf-8")
        return job.call([program("kf-slam"), job.folder / "kf-slam.ini", job.folder / "bag.rawlog"],
                        job.folder / "log.txt")

    @staticmethod
    def _poses(made, count):
        paths = [made / f"robot_pose_{step:05d}.txt" for step in range(count)]
        try:
            return np.array([np.loadtxt(path) for path in paths]).reshape(-1, 3)
        except (OSError, ValueError):
            raise BenchError(f"kf-slam did not write {count} poses into {made}: it is of another "
                             "version") from None

    def run(self, job):
        seen = self._observations(job)
        poses, covered = interpolate(read_odometry(job.bag), [each.stamp for each in seen])
        seen = [each for each, is_covered in zip(seen, covered) if is_covered]
        if not any(each.ids for each in seen):
            raise BenchError(f"{job.bag} shows no landmark with an id while there is odometry")
        odometry = Trajectory(np.array([each.stamp for each in seen]), poses[covered])
        sigmas = self._sigmas(seen)
        self._write_rawlog(job, odometry, seen, sigmas)
        usage, made = self._call(job, sigmas), job.folder / "map"
        write_trajectory(job.folder / "trajectory.tum",
                         Trajectory(odometry.stamps, self._poses(made, len(seen))))
        write_trajectory(job.folder / "odometry.tum", odometry)
        found = read_kf_slam_map(made / scene_name(len(seen) - 1), job.folder / "bag.rawlog")
        write_landmarks(job.folder / "landmarks.yaml", found.ids, found.positions)
        write_about(job, "mrpt_kf", job.robot or robot_of(job.bag), usage, len(seen))
        for path in made.iterdir():  # a state of each step
            path.unlink()
        made.rmdir()
        return usage
