# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The faults of the benchmark adverse: each changes in a bag just what it is to change."""
import math
import pathlib
import tempfile
import unittest

from geometry_msgs.msg import PoseStamped
import genpy
from nav_msgs.msg import Odometry
import numpy as np
import rosbag
from sensor_msgs.msg import LaserScan
from slam_eval.bench.adverse.faults import BEGIN, FAULTS
from slam_eval.bench.harness import landmark_sensor as sensor
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

START, RATE, SECONDS = 100.0, 10, 45  # [s], [1/s], [s]
PLACES = np.array([[2.0, 3.0], [5.0, -2.0], [8.0, 2.0], [1.0, -1.5]])


def pose_at(time):
    """Where the robot is after so many seconds: on a circle of 2 m."""
    angle = 0.2 * time
    return 2.0 * math.sin(angle), 2.0 - 2.0 * math.cos(angle), math.remainder(angle, 2 * math.pi)


def fill(message, pose):
    """Sets a pose message."""
    message.position.x, message.position.y = pose[:2]
    message.orientation.z, message.orientation.w = math.sin(pose[2] / 2), math.cos(pose[2] / 2)


def place(message):
    """(x, y, theta) of a message of odometry."""
    pose = message.pose.pose
    return pose.position.x, pose.position.y, 2 * math.atan2(pose.orientation.z, pose.orientation.w)


class Bags(unittest.TestCase):
    """A drive of 45 s with odometry, truth, scans and observations."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.source = cls.folder / "drive.bag"
        cls.write(cls.source)
        cls.before = cls.read(cls.source)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def write(cls, path):
        """The bag without any fault."""
        look = sensor.Sensor([7, 8, 9, 10], PLACES, 1)
        with rosbag.Bag(str(path), "w") as bag:
            bag.write("/robot", String("sim_segway"), genpy.Time.from_sec(START))
            for i in range(RATE * SECONDS):
                stamp, pose = genpy.Time.from_sec(START + i / RATE), pose_at(i / RATE)
                odometry, truth = Odometry(), PoseStamped()
                fill(odometry.pose.pose, pose)
                fill(truth.pose, pose)
                odometry.twist.twist.linear.x, odometry.twist.twist.angular.z = 0.4, 0.2
                scan = LaserScan(angle_min=-1.0, angle_max=1.0, angle_increment=0.02, range_min=0.1,
                                 range_max=5.0, ranges=[1.0 + 0.01 * ((i + k) % 101)
                                                        for k in range(100)] + [math.inf])
                for topic, message in (("/odom", odometry), ("/ground_truth/pose", truth),
                                       ("/scan", scan)):
                    message.header.stamp = stamp
                    bag.write(topic, message, stamp)
                bag.write("/observations", look.look(stamp, pose), stamp)
                bag.write("/tf", TFMessage(), stamp)

    @staticmethod
    def read(path):
        """{topic: [(time [s], type and bytes, message)]}."""
        found = {}
        with rosbag.Bag(str(path)) as bag:
            for topic, raw, time in bag.read_messages(raw=True):
                found.setdefault(topic, []).append(
                    (time.to_sec() - START, raw[:2], raw[-1]().deserialize(raw[1])))
        return found

    def put(self, name, seed=1):
        """The bag with a fault, as read()."""
        path = self.folder / f"{name}.bag"
        FAULTS[name].put(self.source, path, seed)
        return self.read(path)

    def changed(self, name, *topics):
        """[(time, message before, message after)] of the messages that a fault has changed. They
        are all of these topics, lie in the fault's time, and nothing else has changed."""
        after, begin, pairs = self.put(name), FAULTS[name].begin, []
        for topic, messages in self.before.items():
            if topic == "/tf":
                self.assertNotIn(topic, after)
                continue
            self.assertEqual(len(messages), len(after[topic]), topic)
            for (time, raw, old), (its_time, its_raw, new) in zip(messages, after[topic]):
                self.assertEqual(time, its_time)
                if raw != its_raw:
                    self.assertIn(topic, topics)
                    self.assertGreaterEqual(time, begin - 1e-6)
                    self.assertEqual(old.header, new.header)
                    pairs.append((time, old, new))
        self.assertTrue(pairs)
        return pairs

    @staticmethod
    def after(messages, topic, begin):
        """The messages of a topic from a time on."""
        return [message for time, _, message in messages[topic] if time >= begin]

    def test_a_clean_drive_is_the_same_bag(self):
        target = self.folder / "clean.bag"
        FAULTS["clean"].put(self.source, target, 1)
        self.assertEqual(target.read_bytes(), self.source.read_bytes())

    def test_a_robot_is_carried_while_its_odometry_does_not_notice(self):
        after = self.put("carried")
        steps = np.diff([place(m)[:2] for _, _, m in after["/odom"]], axis=0)
        self.assertLess(np.hypot(*steps.T).max(), 0.05)
        truth = np.array([(m.pose.position.x, m.pose.position.y)
                          for _, _, m in after["/ground_truth/pose"]])
        jumps = np.hypot(*np.diff(truth, axis=0).T)
        self.assertEqual(np.flatnonzero(jumps > 0.1).tolist(), [RATE * BEGIN - 1])
        np.testing.assert_allclose(truth[-1], pose_at(SECONDS - 1 / RATE)[:2], atol=1e-6)
        self.assertEqual(len(after["/scan"]), RATE * (SECONDS - 10))
        self.assertEqual([m.ranges for _, _, m in after["/scan"][:200]],
                         [m.ranges for _, _, m in self.before["/scan"][:200]])

    def test_wheels_scale_each_motion_from_the_start(self):
        for factor in (0.7, 1.3):
            pairs = self.changed(f"wheels_{factor}", "/odom")
            self.assertGreaterEqual(len(pairs), RATE * SECONDS - 1)
            for time, old, new in pairs[5::50]:
                # A circle of the same radius, of which another part was driven.
                angle = 0.2 * time * factor
                x, y, theta = place(new)
                self.assertAlmostEqual(math.remainder(theta - angle, 2 * math.pi), 0.0, 6)
                self.assertAlmostEqual(math.hypot(x, y - 2.0), 2.0, delta=0.01)
                self.assertAlmostEqual(new.twist.twist.linear.x, 0.4 * factor)
                self.assertAlmostEqual(new.twist.twist.angular.z, 0.2 * factor)
                self.assertEqual(old.pose.covariance, new.pose.covariance)

    def test_ranges_are_scaled_and_bearings_are_not(self):
        for factor in (0.8, 1.2):
            pairs = self.changed(f"ranges_{factor}", "/observations", "/scan")
            self.assertGreaterEqual(len(pairs), RATE * SECONDS)
            for _, old, new in pairs[::20]:
                if hasattr(old, "observations"):
                    for a, b in zip(old.observations, new.observations):
                        self.assertAlmostEqual(b.range, factor * a.range)
                        self.assertEqual((a.id, a.bearing, a.covariance),
                                         (b.id, b.bearing, b.covariance))
                else:
                    np.testing.assert_allclose(new.ranges, factor * np.array(old.ranges), 1e-6)
                    self.assertEqual(new.ranges[-1], math.inf)
                    self.assertAlmostEqual(new.range_max, factor * 5.0, 5)
                    self.assertEqual(old.angle_min, new.angle_min)

    def test_bearings_turn_and_ranges_stay(self):
        for _, old, new in self.changed("bearings", "/observations", "/scan")[::20]:
            if hasattr(old, "observations"):
                for a, b in zip(old.observations, new.observations):
                    self.assertAlmostEqual(math.remainder(b.bearing - a.bearing, 2 * math.pi), 0.1)
                    self.assertLessEqual(abs(b.bearing), math.pi)
                    self.assertEqual((a.id, a.range), (b.id, b.range))
            else:
                self.assertAlmostEqual(new.angle_min, old.angle_min + 0.1, 6)
                self.assertAlmostEqual(new.angle_max, old.angle_max + 0.1, 6)
                self.assertEqual(old.ranges, new.ranges)

    def test_odometry_stands_still_and_what_was_driven_meanwhile_is_lost(self):
        pairs = self.changed("odometry_stuck", "/odom")
        stuck = [new for time, _, new in pairs if time < BEGIN + 10.0 - 1e-6]
        self.assertEqual(len(stuck), 10 * RATE)
        before = pose_at(BEGIN - 1 / RATE)
        for message in stuck:
            np.testing.assert_allclose(place(message), before, atol=1e-9)
            self.assertEqual(message.twist.twist.linear.x, 0.0)
        for time, _, new in pairs[len(stuck)::20]:
            np.testing.assert_allclose(place(new)[:2], pose_at(time - 10.0)[:2], atol=1e-6)
            self.assertEqual(new.twist.twist.linear.x, 0.4)

    def test_odometry_jumps_in_one_message(self):
        (time, old, new), = self.changed("odometry_jump", "/odom")
        self.assertAlmostEqual(time, BEGIN)
        self.assertEqual(new.pose.pose.position.x - old.pose.pose.position.x, 1e9)
        self.assertEqual(old.twist, new.twist)

    def test_half_of_the_ids_are_those_of_other_landmarks(self):
        self.changed("false_ids", "/observations")
        after = self.after(self.put("false_ids"), "/observations", BEGIN)
        before = self.after(self.before, "/observations", BEGIN)
        pairs = [(a, b) for old, new in zip(before, after)
                 for a, b in zip(old.observations, new.observations)]
        false = [b.id for a, b in pairs if a.id != b.id]
        self.assertGreater(len(pairs), 200)
        self.assertAlmostEqual(len(false) / len(pairs), 0.5, delta=0.1)
        self.assertEqual(set(false), {7, 8, 9, 10})
        for a, b in pairs:
            self.assertEqual((a.range, a.bearing), (b.range, b.bearing))

    def test_each_landmark_moves_by_half_a_metre_in_one_direction_of_its_own(self):
        shifts = {}
        for time, old, new in self.changed("landmarks_moved", "/observations"):
            self.assertEqual(len(old.observations), len(new.observations))
            for a, b in zip(old.observations, new.observations):
                self.assertEqual(a.id, b.id)
                was, now = (sensor.place_of(pose_at(time), z.range, z.bearing) for z in (a, b))
                shifts.setdefault(a.id, []).append(now - was)
        self.assertEqual(set(shifts), {7, 8, 9, 10})
        for of_one in shifts.values():
            self.assertLess(np.ptp(of_one, axis=0).max(), 1e-6)
            self.assertAlmostEqual(np.hypot(*of_one[0]), 0.5)
        self.assertGreater(np.hypot(*(shifts[7][0] - shifts[8][0])), 0.01)

    def test_another_seed_draws_other_ids_and_directions(self):
        for name in ("false_ids", "landmarks_moved"):
            first, again, other = (self.put(name, seed)["/observations"] for seed in (1, 1, 2))
            self.assertEqual([raw for _, raw, _ in first], [raw for _, raw, _ in again])
            self.assertNotEqual([raw for _, raw, _ in first], [raw for _, raw, _ in other])

    def test_a_laser_freezes(self):
        pairs = self.changed("laser_frozen", "/scan")
        self.assertGreater(len(pairs), 200)
        kept = self.after(self.before, "/scan", BEGIN)[0].ranges
        self.assertTrue(all(new.ranges == kept for _, _, new in pairs))

    def test_a_laser_is_mirrored(self):
        pairs = self.changed("laser_mirrored", "/scan")
        self.assertEqual(len(pairs), RATE * (SECONDS - BEGIN))
        for _, old, new in pairs:
            self.assertEqual(new.ranges, old.ranges[::-1])
            self.assertEqual(new.angle_min, old.angle_min)

    def test_a_laser_measures_one_range(self):
        pairs = self.changed("laser_constant", "/scan")
        self.assertEqual(len(pairs), RATE * (SECONDS - BEGIN))
        self.assertTrue(all(set(new.ranges) == {2.0} and len(new.ranges) == 101
                            for _, _, new in pairs))


if __name__ == "__main__":
    unittest.main()
