# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the benchmark lost makes of runs, and the buildings and bags it makes, without any run."""
import math
import pathlib
import tempfile
import types
import unittest

from geometry_msgs.msg import PoseStamped
import genpy
from nav_msgs.msg import Odometry
import numpy as np
import rosbag
from sensor_msgs.msg import CompressedImage, LaserScan
from slam_eval.bench.harness import bag_edit, buildings
from slam_eval.bench.lost import alarms, drives
from slam_eval.io.trajectory import Trajectory

STEP = 0.1  # [m] and [s]


def run(count=400, off=None, told=None):
    """A robot that drives straight on; off: error [m] by the step's number."""
    stamps = np.arange(count, dtype=np.int64) * 10**8
    true = np.column_stack([STEP * np.arange(count), np.zeros(count), np.zeros(count)])
    seen = true.copy()
    for i, error in (off or {}).items():
        seen[i, 1] += error
    metrics = {} if told is None else {"lost_first_s": told}
    return types.SimpleNamespace(trajectory=Trajectory(stamps, seen),
                                 truth=Trajectory(stamps, true), metrics=metrics)


class Verdicts(unittest.TestCase):

    def test_a_right_run_without_alarm_is_neither_wrong_nor_false(self):
        verdict = alarms.judge(run())
        self.assertIsNone(verdict.wrong)
        self.assertFalse(verdict.is_false)
        self.assertAlmostEqual(verdict.hours, 39.9 / 3600)

    def test_an_alarm_of_a_right_run_is_false(self):
        self.assertTrue(alarms.judge(run(told=20.0)).is_false)

    def test_an_alarm_counts_by_the_way_since_the_pose_was_wrong(self):
        wrong = {i: 2.0 for i in range(200, 400)}
        in_time = alarms.judge(run(off=wrong, told=24.0))
        self.assertAlmostEqual(in_time.way, 4.0)
        self.assertTrue(in_time.is_in_time)
        late = alarms.judge(run(off=wrong, told=28.0))
        self.assertFalse(late.is_in_time or late.is_false)
        never = alarms.judge(run(off=wrong))
        self.assertFalse(never.is_in_time)

    def test_an_alarm_before_anything_went_wrong_is_false_and_not_in_time(self):
        early = alarms.judge(run(off={i: 2.0 for i in range(200, 400)}, told=5.0))
        self.assertTrue(early.is_false)
        self.assertFalse(early.is_in_time)

    def test_a_robot_that_is_soon_found_again_is_not_wrong(self):
        found = alarms.judge(run(off={i: 2.0 for i in range(200, 230)}, told=21.0))
        self.assertIsNone(found.wrong)
        self.assertFalse(found.is_false)

    def test_in_another_map_all_is_wrong_from_the_start(self):
        self.assertTrue(alarms.wrong_from_start(run(told=4.0)).is_in_time)
        self.assertFalse(alarms.wrong_from_start(run(told=6.0)).is_in_time)
        self.assertFalse(alarms.wrong_from_start(run()).is_in_time)


class Tables(unittest.TestCase):

    def verdicts(self):
        """One right run of five hours with a false alarm, one wrong one told, one not."""
        return [alarms.Verdict(5.0, None, 3.0, None, True),
                alarms.Verdict(2.5, 10.0, 12.0, 1.5, False),
                alarms.Verdict(2.5, 10.0, None, math.inf, False)]

    def test_false_alarms_and_what_is_told_have_their_limits(self):
        self.assertEqual(drives.row("all", self.verdicts()),
                         ["all", "3", "10.00", "1", "2", "1", "50.0"])
        lines = drives.verdict_lines(self.verdicts())
        self.assertIn("1.00 (<= 1: reached)", lines)
        self.assertIn("50.0 % (>= 95: MISSED)", lines)

    def test_what_went_wrong_is_named(self):
        right, told, missed = self.verdicts()
        lines = drives.exceptions({"mapping": {3: right}, "carried": {3: told, 4: missed}})
        self.assertEqual(len(lines.splitlines()), 2)
        self.assertIn("false alarm: mapping, building 3", lines)
        self.assertIn("told never: carried, building 4", lines)


class Buildings(unittest.TestCase):

    def test_a_seed_makes_one_building(self):
        self.assertEqual(buildings.building(7), buildings.building(7))
        self.assertNotEqual(buildings.building(7)["walls"], buildings.building(8)["walls"])

    def test_furniture_leaves_the_way_free(self):
        for seed in range(1, 6):
            world = buildings.building(seed)
            self.assertGreater(len(world["furniture"]), 5)
            for box in world["furniture"]:
                low = [c - s / 2 for c, s in zip(box["centre"], box["size"])]
                high = [c + s / 2 for c, s in zip(box["centre"], box["size"])]
                for point in world["path"]["points"]:
                    nearest = [min(max(p, a), b) for p, a, b in zip(point, low, high)]
                    self.assertGreater(math.dist(point, nearest), 0.22)


class Bags(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bag(self):
        """A robot that drives along x for 10 s and sees a wall 4 m around it."""
        path = self.folder / "drive.bag"
        with rosbag.Bag(str(path), "w") as bag:
            for i in range(100):
                stamp = genpy.Time.from_sec(100.0 + 0.1 * i)
                for topic, message in (("/odom", Odometry()), ("/truth", PoseStamped())):
                    message.header.stamp = stamp
                    pose = message.pose.pose if topic == "/odom" else message.pose
                    pose.position.x, pose.orientation.w = 0.1 * i, 1.0
                    bag.write(topic, message, stamp)
                scan = LaserScan(angle_min=-1.0, angle_max=1.0, angle_increment=0.01,
                                 range_max=5.0, ranges=[4.0] * 201)
                scan.header.stamp = stamp
                bag.write("/scan", scan, stamp)
                image = CompressedImage(format="jpeg", data=b"%d" % i)
                image.header.stamp = stamp
                bag.write("/camera/image_raw/compressed", image, stamp)
        return path

    def messages(self, path, topic):
        """All of a topic."""
        with rosbag.Bag(str(path)) as bag:
            return [message for _, message, _ in bag.read_messages(topics=[topic])]

    def test_a_carried_robot_goes_on_elsewhere_and_its_odometry_does_not_notice(self):
        cut = self.folder / "cut.bag"
        bag_edit.rewrite(self.bag(), cut, carried=bag_edit.Carried(4.0, 7.0, 2.0))
        odometry, truth = self.messages(cut, "/odom"), self.messages(cut, "/truth")
        steps = np.diff([m.pose.pose.position.x for m in odometry])
        self.assertLess(steps.max(), 0.11)
        jumps = np.diff([m.pose.position.x for m in truth])
        self.assertAlmostEqual(jumps.max(), 3.1, 2)
        stamps = np.array([m.header.stamp.to_sec() for m in self.messages(cut, "/scan")])
        self.assertTrue(np.allclose(np.diff(stamps), 0.1, atol=1e-6))
        self.assertAlmostEqual(stamps[-1], 106.0, 1)
        images = self.messages(cut, "/camera/image_raw/compressed")
        self.assertEqual([int(m.data) for m in images], [*range(40), *range(70, 91)])
        self.assertEqual([m.header.stamp.to_sec() for m in images], list(stamps))

    def test_people_shorten_some_beams_and_lengthen_none(self):
        peopled = self.folder / "people.bag"
        bag_edit.rewrite(self.bag(), peopled, bag_edit.People(3, 1.0))
        ranges = np.array([m.ranges for m in self.messages(peopled, "/scan")])
        self.assertTrue(np.all(ranges <= 4.0))
        self.assertGreater(np.count_nonzero(ranges < 3.9), 20)
        self.assertLess(np.mean(ranges < 3.9), 0.5)
        self.assertEqual(len(self.messages(peopled, "/odom")), 100)


if __name__ == "__main__":
    unittest.main()
