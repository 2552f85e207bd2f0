# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the benchmark relocalisation makes of runs and bags, without any run."""
import pathlib
import tempfile
import types
import unittest

import genpy
from nav_msgs.msg import Odometry
import numpy as np
import rosbag
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.relocalisation.judge import judge, Outcome
from slam_eval.bench.relocalisation.log import Log, renaming, Slip
from slam_eval.bench.relocalisation.markers import mapped, SecondMarker
from slam_eval.bench.relocalisation.starts import draw, SECOND, Start
from slam_eval.io.trajectory import Trajectory
from slam_msgs.msg import LandmarkObservation, LandmarkObservationArray
from std_msgs.msg import String

T0 = 1000 * SECOND


def run(off=0.0, turn=0.0, sigma=0.1, sure_from=20, count=40):
    """A robot that stands, sure of its pose from a step on, and so far off."""
    stamps = T0 + np.arange(count, dtype=np.int64) * SECOND // 10
    poses = np.tile([off, 0.0, turn], (count, 1))
    covariances = np.tile(sigma ** 2 * np.eye(3), (count, 1, 1))
    covariances[:sure_from] = 100.0 * np.eye(3)
    truth = Trajectory(stamps, np.zeros((count, 3)))
    updates = types.SimpleNamespace(covariances=covariances)
    return types.SimpleNamespace(trajectory=Trajectory(stamps, poses), updates=updates), truth


class Verdicts(unittest.TestCase):

    def test_a_robot_that_is_sure_of_the_right_place_is_right(self):
        verdict = judge(*run(off=0.2), T0)
        self.assertIs(verdict.outcome, Outcome.RIGHT)
        self.assertAlmostEqual(verdict.seconds, 2.0)
        self.assertAlmostEqual(verdict.error, 0.2)

    def test_a_robot_that_is_never_sure_did_not_know(self):
        self.assertIs(judge(*run(off=9.0, sure_from=40), T0).outcome, Outcome.UNKNOWN)

    def test_a_robot_that_is_sure_of_a_wrong_place_is_wrong(self):
        self.assertIs(judge(*run(off=2.0), T0).outcome, Outcome.WRONG)
        self.assertIs(judge(*run(turn=1.0), T0).outcome, Outcome.WRONG)

    def test_a_robot_that_is_off_within_what_it_reports_is_neither(self):
        self.assertIs(judge(*run(off=0.6, sigma=0.19), T0).outcome, Outcome.UNKNOWN)

    def test_poses_before_they_are_judged_do_not_count(self):
        made, truth = run(off=0.0)
        made.trajectory.poses[20:25, 0] = 3.0
        self.assertIs(judge(made, truth, T0).outcome, Outcome.WRONG)
        self.assertIs(judge(made, truth, T0, T0 + 5 * SECOND // 2).outcome, Outcome.RIGHT)


class Logs(unittest.TestCase):

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.bag = pathlib.Path(self._folder.name) / "drive.bag"
        with rosbag.Bag(str(self.bag), "w") as bag:
            bag.write("/robot", String("sim"), genpy.Time(1000))
            for i in range(100):
                time = genpy.Time(*divmod(T0 + i * SECOND // 10, SECOND))
                odometry = Odometry()
                odometry.header.stamp = time
                odometry.pose.pose.position.x = 0.1 * i
                odometry.pose.pose.orientation.w = 1.0
                bag.write("/odom", odometry, time)
                seen = LandmarkObservationArray()
                seen.header.stamp = time
                seen.observations = [LandmarkObservation(id=i // 20)]
                bag.write("/observations", seen, time)

    def _written(self, log, **arguments):
        path = self.bag.with_name("part.bag")
        log.write(path, **arguments)
        with rosbag.Bag(str(path)) as bag:
            return [(topic, message) for topic, message, _ in bag.read_messages()]

    def test_a_part_has_its_messages_and_what_is_latched(self):
        written = self._written(Log(self.bag), start=T0 + 2 * SECOND, end=T0 + 3 * SECOND)
        self.assertEqual(written[0][0], "/robot")
        stamps = [m.header.stamp.to_nsec() for topic, m in written if topic == "/odom"]
        self.assertEqual((stamps[0], stamps[-1], len(stamps)), (T0 + 2 * SECOND, T0 + 3 * SECOND, 11))

    def test_markers_get_other_ids(self):
        log = Log(self.bag, change=renaming({0: 3}))
        self.assertEqual(log.observations()[0], (T0, [3]))
        self.assertEqual(log.observations()[99][1], [4])

    def test_wheels_that_slip_move_the_odometry_for_good(self):
        written = self._written(Log(self.bag), start=T0, end=T0 + 9 * SECOND,
                                change=Slip(T0 + 5 * SECOND, np.pi / 2, 0.2))
        places = [m.pose.pose.position for topic, m in written if topic == "/odom"]
        self.assertAlmostEqual(places[49].x, 4.9)
        self.assertAlmostEqual(places[50].x, 5.2)
        self.assertAlmostEqual(places[60].x, 5.2)
        self.assertAlmostEqual(places[60].y, 1.0)

    def test_the_time_counts_from_the_second_marker(self):
        start_of = SecondMarker(Log(self.bag), {0, 1, 2})
        self.assertEqual(start_of(T0 + SECOND), Start(T0 + SECOND, T0 + 2 * SECOND, T0 + 6 * SECOND))
        self.assertIsNone(start_of(T0 + 5 * SECOND))  # of those behind only one is in the map

    def test_of_two_markers_with_one_id_the_map_has_the_first(self):
        arrays = [(1, [4]), (2, [7, 8]), (3, [4])]
        self.assertEqual(mapped(arrays, {8: 4}, [4, 7, 9]), {4, 7})
        self.assertEqual(mapped(arrays, {4: 8}, [8, 7]), {4, 7})

    def test_starts_are_the_same_for_the_same_seed(self):
        log, start_of = Log(self.bag), SecondMarker(Log(self.bag), {0, 1, 2})
        self.assertEqual(draw(5, 1, log, start_of), draw(5, 1, log, start_of))
        self.assertNotEqual(draw(5, 1, log, start_of), draw(5, 2, log, start_of))

    def test_a_drive_without_starts_is_told(self):
        with self.assertRaisesRegex(BenchError, "only 0 can be starts"):
            draw(5, 1, Log(self.bag), lambda stamp: None)


if __name__ == "__main__":
    unittest.main()
