# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What foreign systems are fed with, and what is made of their answers."""
import math
import pathlib
import subprocess
import tempfile
import unittest

import run_maker  # noqa: F401, before slam_eval: it finds the source tree
import numpy as np
import rosbag
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.foreign.bag_data import has_topic, planar, read_observations, read_odometry
from slam_eval.foreign.driver import Job
from slam_eval.foreign.mrpt_kf import MrptKf
from slam_eval.foreign.mrpt_rawlog import MotionNoise, Observations, write_rawlog
from slam_eval.foreign.results import (
    with_odometry_between, write_grid, write_landmarks, write_trajectory)
from slam_eval.foreign.ros_node import complaint, map_base
from slam_eval.geometry import se2
from slam_eval.io.grid_map import FREE, OCCUPIED, read_grid, UNKNOWN
from slam_eval.io.landmarks import read_landmarks
from slam_eval.io.trajectory import read_trajectory, Trajectory

NOISE = MotionNoise(0.03, 0.0, 0.02, 0.03, 0.001, 0.0004)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Rawlog(InFolder):
    """The importer, which reads with MRPT itself, finds what was written."""

    def setUp(self):
        super().setUp()
        self.increments = [(0.0, 0.0, 0.0), (0.5, 0.1, 0.2), (0.4, -0.1, -0.3)]
        self.seen = [Observations(0, (0.2, 0.1, 0.5), [7, 3], [2.0, 3.5], [0.25, -0.5]),
                     Observations(1, (0.2, 0.1, 0.5), [], [], []),
                     Observations(2, (0.2, 0.1, 0.5), [3], [3.0], [-0.75])]
        write_rawlog(self.folder / "a.rawlog", self.increments, self.seen, NOISE, (0.02, 0.01))
        self.bag = self.folder / "a.bag"
        subprocess.run([workspace_program("slam_eval", "slam_import"), "rawlog",
                        self.folder / "a.rawlog", self.bag], check=True, stdout=subprocess.DEVNULL)

    def test_holds_the_motion(self):
        poses = [np.zeros(3)]
        for increment in self.increments:
            poses.append(se2.compose(poses[-1], increment))
        np.testing.assert_allclose(read_odometry(self.bag).poses[-3:], poses[1:], atol=1e-9)

    def test_holds_the_observations(self):
        found = read_observations(self.bag)
        self.assertEqual([each.ids for each in found], [[7, 3], [], [3]])
        np.testing.assert_allclose(found[0].ranges, [2.0, 3.5])
        np.testing.assert_allclose(found[2].bearings, [-0.75])
        np.testing.assert_allclose(found[0].sensor, (0.2, 0.1, 0.5), atol=1e-6)
        np.testing.assert_allclose(found[0].sigmas, [(0.02, 0.01)] * 2, rtol=1e-6)

    def test_has_the_same_bytes_once_more(self):
        write_rawlog(self.folder / "b.rawlog", self.increments, self.seen, NOISE, (0.02, 0.01))
        self.assertEqual((self.folder / "a.rawlog").read_bytes(),
                         (self.folder / "b.rawlog").read_bytes())

    def refused_by_kf_slam(self, bag, **sigmas):
        """What the driver says before it calls a program."""
        with self.assertRaises(BenchError) as caught:
            MrptKf({"range_sigma": None, "bearing_sigma_deg": None, **sigmas}).run(
                Job(bag, self.folder, 1, None, (), None))
        return str(caught.exception)

    def test_needs_both_standard_deviations_or_none(self):
        self.assertIn("range_sigma is set and bearing_sigma_deg is not; set both",
                      self.refused_by_kf_slam(self.bag, range_sigma=0.1))
        self.assertIn("bearing_sigma_deg is set and range_sigma is not; set both",
                      self.refused_by_kf_slam(self.bag, bearing_sigma_deg=1.0))

    def test_without_standard_deviations_needs_them_set(self):
        bare = self.folder / "bare.bag"
        with rosbag.Bag(str(self.bag)) as bag, rosbag.Bag(str(bare), "w") as copy:
            for topic, message, stamp in bag.read_messages():
                if topic.lstrip("/") == "observations":
                    for each in message.observations:
                        each.covariance = [0.0] * len(each.covariance)
                copy.write(topic, message, stamp)
        self.assertIn("the observations claim no standard deviations; set range_sigma and "
                      "bearing_sigma_deg", self.refused_by_kf_slam(bare))

    def test_is_told_from_other_topics(self):
        self.assertTrue(has_topic(self.bag, "observations"))
        self.assertFalse(has_topic(self.bag, "scan"))
        with rosbag.Bag(str(self.bag)) as bag:
            first = next(iter(bag.read_messages(topics=["/odom"]))).message
        self.assertEqual(planar(first.pose.pose), (0.0, 0.0, 0.0))


class Complaint(InFolder):
    def of(self, text):
        (self.folder / "log.txt.err").write_text(text, encoding="utf-8")
        return complaint(self.folder / "log.txt")

    def test_names_the_node_that_has_died(self):
        self.assertEqual(
            self.of("[ERROR] [1.0]: Error: late\n\x1b[31m[slow-2] process has died [pid 7, exit "
                    "code 1, cmd /a/slow].\nlog file: /b\x1b[0m\n"),
            "; its node slow has died with exit code 1")

    def test_names_the_node_that_cannot_be_started(self):
        self.assertEqual(self.of("ERROR: cannot launch node of type [a/b]: a\n"),
                         "; roslaunch said: ERROR: cannot launch node of type [a/b]: a")

    def test_else_names_the_log(self):
        self.assertEqual(self.of("[foreign_recorder-3] process has died [pid 7, exit code 1]\n"),
                         "; the run's log.txt says more")


class Answers(InFolder):
    def test_trajectories_are_read_as_written(self):
        stamps = np.array([1_700_000_000_123_456_789, 1_700_000_001_000_000_001])
        poses = np.array([[1.0, -2.0, 3.0], [0.5, 0.25, -3.0]])
        write_trajectory(self.folder / "a.tum", Trajectory(stamps, poses))
        found = read_trajectory(self.folder / "a.tum")
        np.testing.assert_array_equal(found.stamps, stamps)
        np.testing.assert_allclose(found.poses, poses, atol=1e-8)

    def test_landmarks_are_read_as_written(self):
        two = np.array([[1.0, 2.0], [3.0, 4.5]])
        for ids, positions in (([4, 2], two), ([], np.empty((0, 2)))):
            write_landmarks(self.folder / "a.yaml", ids, positions)
            found = read_landmarks(self.folder / "a.yaml")
            self.assertEqual(found.ids, ids)
            np.testing.assert_allclose(found.positions, positions)

    def test_grids_are_read_as_written(self):
        write_grid(self.folder, np.array([[1.0, 0.5, 0.0], [0.5, 0.5, 1.0]]), 0.1, (-1.0, 2.0))
        grid = read_grid(self.folder / "map.yaml")
        np.testing.assert_array_equal(grid.cells, [[UNKNOWN, UNKNOWN, FREE],
                                                   [FREE, UNKNOWN, OCCUPIED]])
        self.assertEqual((grid.resolution, tuple(grid.origin)), (0.1, (-1.0, 2.0)))

    def test_odometry_fills_what_is_between_frames(self):
        odometry = Trajectory(np.arange(5), np.array([[float(i), 0.0, 0.0] for i in range(5)]))
        path = Trajectory(np.array([1, 3]), np.array([[0.0, 0.0, math.pi / 2], [5.0, 5.0, 0.0]]))
        found = with_odometry_between(path, odometry)
        np.testing.assert_array_equal(found.stamps, [1, 2, 3, 4])
        np.testing.assert_allclose(found.poses[:, :2], [[0, 0], [0, 1], [5, 5], [6, 5]], atol=1e-12)

    def test_a_published_transform_is_applied_to_the_odometry_of_its_time(self):
        second = 1_000_000_000
        corrections = Trajectory(np.array([1, 2]) * second, np.array([[0.0, 0.0, 0.0],
                                                                      [1.0, 0.0, 0.0]]))
        odometry = Trajectory(np.arange(0, 31) * second // 10, np.zeros((31, 3)) + [2.0, 0.0, 0.0])
        found = map_base(corrections, odometry, np.array([5, 10, 15, 25]) * second // 10)
        np.testing.assert_array_equal(found.stamps, [second, second * 3 // 2])
        np.testing.assert_allclose(found.poses[:, 0], [2.0, 2.5])


if __name__ == "__main__":
    unittest.main()
