#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What laser odometry publishes, with walls around it, blind, and beside another odometry."""

import copy
import math
import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
import numpy
from player import wait_for
import rosbag
from rosgraph_msgs.msg import Log
import rospy
import rostest
from sensor_msgs.msg import LaserScan
from slam_msgs.msg import Motion
from tf2_msgs.msg import TFMessage

SECONDS = 8
TOPICS = {"/scan": LaserScan, "/tf_static": TFMessage}
OUTPUTS = {"motion": Motion, "laser_odometry/odom": Odometry, "compared/odom": Odometry,
           "/tf": TFMessage, "/rosout": Log, "/diagnostics": DiagnosticArray}


def read_log():
    """Returns the (topic, message) of a simulated drive."""
    program = find_in_workspaces(["libexec"], "slam_sim", "slam_sim", first_match_only=True)[0]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "drive.bag")
        subprocess.run([program, path, "--duration", str(SECONDS), "--only", "odom,scan"],
                       check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(path) as bag:
            return [(topic, message) for topic, message, _ in bag.read_messages()]


def planar(pose):
    """(x, y, heading) of a message."""
    q = pose.orientation
    return numpy.array([pose.position.x, pose.position.y, 2.0 * math.atan2(q.z, q.w)])


def between(first, second):
    """The second pose in the frame of the first."""
    c, s = math.cos(first[2]), math.sin(first[2])
    x, y = second[:2] - first[:2]
    return numpy.array([c * x + s * y, c * y - s * x, second[2] - first[2]])


def blind(message):
    """A scan with the stamp of a message that met nothing."""
    empty = copy.deepcopy(message)
    empty.ranges = [math.inf] * len(message.ranges)
    return empty


class LaserOdometryTest(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.has_wheels = rospy.get_param("~odometry") == "laser_wheel"
        kinds = {**TOPICS, **({"/odom": Odometry} if cls.has_wheels else {})}
        log = read_log()
        cls.truth = {m.header.stamp: planar(m.pose) for topic, m in log
                     if topic == "/ground_truth/pose"}
        cls.steps = cls.split([(topic, m) for topic, m in log if topic in kinds])
        cls.lock = threading.Lock()
        cls.received = {topic: [] for topic in OUTPUTS}
        cls.publishers = {topic: rospy.Publisher(topic, kind, queue_size=100,
                                                 latch=topic == "/tf_static")
                          for topic, kind in kinds.items()}
        cls.transforms = rospy.Publisher("/tf", TFMessage, queue_size=10)
        cls.subscribers = [rospy.Subscriber(topic, kind, cls.keep, topic, queue_size=1000)
                           for topic, kind in OUTPUTS.items()]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0
                                             for p in cls.publishers.values()), 30)
        cls.connected &= wait_for(lambda: all(s.get_num_connections() > 0
                                              for s in cls.subscribers[:3]), 30)
        time.sleep(0.5)  # a nodelet advertises before it subscribes
        cls.publishers["/tf_static"].publish(next(m for topic, m in log if topic == "/tf_static"))
        time.sleep(1.0)
        cls.sent = 0

    @staticmethod
    def split(log):
        """The messages up to each scan and shortly behind it, so that wheels cover its stamp."""
        steps = []
        for topic, message in log:
            if topic == "/scan":
                steps.append([])
            if steps and topic != "/tf_static":
                steps[-1].append((topic, message))
        return steps

    @classmethod
    def keep(cls, message, topic):
        with cls.lock:
            cls.received[topic].append(message)

    def get(self, topic):
        with self.lock:
            return list(self.received[topic])

    def send(self, count, change=lambda message: message):
        """Sends the next scans and what comes with them."""
        for step in self.steps[self.sent:self.sent + count]:
            for topic, message in step:
                self.publishers[topic].publish(change(message) if topic == "/scan" else message)
                time.sleep(0.002)
            time.sleep(0.02)
        type(self).sent += count

    def stamps(self):
        """Of the scans that have been sent."""
        return [step[0][1].header.stamp for step in self.steps[:self.sent]]

    def motions(self, count):
        self.assertTrue(wait_for(lambda: len(self.get("motion")) >= count),
                        f"{len(self.get('motion'))} motions came")
        return self.get("motion")

    def test_1_every_scan_after_the_first_yields_a_motion(self):
        self.assertTrue(self.connected)
        self.send(30)
        motions = self.motions(29)
        self.assertEqual([m.sequence for m in motions], list(range(29)))
        self.assertEqual([m.end for m in motions], self.stamps()[1:])
        for motion in motions:
            covariance = numpy.array(motion.covariance).reshape(3, 3)
            self.assertGreater(numpy.linalg.eigvalsh(covariance).min(), 0)
        self.assertEqual({(m.header.frame_id, m.child_frame_id) for m in motions},
                         {("odom", "base_link")})

    def error(self):
        """Of the way from the first to the last scan [m]: the truth is that of nearby stamps."""
        true = numpy.array([stamp.to_sec() for stamp in self.truth])
        poses = numpy.array(list(self.truth.values()))

        def pose_at(stamp):
            return numpy.array([numpy.interp(stamp.to_sec(), true, numpy.unwrap(column))
                                for column in poses.T])
        way = between(pose_at(self.stamps()[0]), pose_at(self.get("motion")[-1].end))
        end = self.get("motion")[-1].odometry_end
        return math.hypot(end.x - way[0], end.y - way[1])

    def test_2_odometry_and_transform_tell_the_same_way(self):
        self.assertTrue(wait_for(lambda: len(self.get("laser_odometry/odom")) >= 29))
        odometry, end = self.get("laser_odometry/odom")[-1], self.get("motion")[-1].odometry_end
        self.assertEqual((odometry.header.frame_id, odometry.child_frame_id),
                         ("odom", "base_link"))
        self.assertAlmostEqual(odometry.pose.pose.position.x, end.x)
        self.assertAlmostEqual(odometry.pose.pose.position.y, end.y)
        self.assertGreater(odometry.pose.covariance[0], 0)
        self.assertTrue(wait_for(lambda: self.edges()), "no transform came")
        self.assertAlmostEqual(self.edges()[-1].transform.translation.x, end.x)
        stamps = [edge.header.stamp for edge in self.edges()]
        self.assertTrue(all(a < b for a, b in zip(stamps, stamps[1:])))

    def edges(self):
        """The transforms of the robot's base."""
        return [t for m in self.get("/tf") for t in m.transforms if t.child_frame_id == "base_link"]

    def values(self):
        """The newest diagnostic of the nodelet."""
        for array in reversed(self.get("/diagnostics")):
            for status in array.status:
                if status.name.startswith("laser_odometry"):
                    return {"message": status.message,
                            **{entry.key: entry.value for entry in status.values}}
        return {}

    def test_3_the_way_is_the_true_one_and_diagnostics_tell_how_well_it_goes(self):
        self.send(20)
        self.motions(49)
        self.assertLess(self.error(), 0.03)
        self.assertTrue(wait_for(lambda: self.values().get("message") == "running"), self.values())
        self.assertTrue(wait_for(lambda: float(self.values().get("known_ends", 0)) > 100))
        values = self.values()
        self.assertLess(float(values["contradicting_ends"]), 0.1)
        for name in ("sigma_position", "map_megabytes", "rate [1/s]"):
            self.assertGreater(float(values[name]), 0, name)

    def test_4_a_blind_laser_is_told_and_time_goes_on(self):
        sure = self.get("motion")[-1].covariance[0]
        self.send(5, blind)
        unsure = self.motions(54)[-1].covariance[0]
        self.assertTrue(self.has_wheels or unsure > 10 * sure)
        self.assertTrue(wait_for(lambda: any("do not tell the robot's motion" in log.msg
                                             for log in self.get("/rosout"))))
        self.send(5)
        self.assertLess(self.motions(59)[-1].covariance[0], 1e-4)
        self.assertLess(self.error(), 0.05)
        self.assertTrue(wait_for(lambda: self.values().get("unmatched") == "5"), self.values())

    def test_5_another_odometry_keeps_its_transform(self):
        edge = TransformStamped(child_frame_id="base_link")
        edge.header.frame_id = "odom"
        edge.header.stamp = self.stamps()[-1]
        edge.transform.rotation.w = 1.0
        self.transforms.publish(TFMessage([edge]))
        time.sleep(0.5)
        self.send(4)
        self.assertEqual(self.motions(63)[-1].header.frame_id, "laser_odom")
        self.assertTrue(wait_for(lambda: any("laser_odom" in log.msg
                                             for log in self.get("/rosout"))))

    def test_6_beside_the_products_odometry_a_second_one_only_tells_its_own(self):
        self.assertTrue(wait_for(lambda: len(self.get("compared/odom")) >= 63),
                        len(self.get("compared/odom")))
        compared = self.get("compared/odom")
        self.assertEqual({(m.header.frame_id, m.child_frame_id) for m in compared},
                         {("laser_odom", "base_link")})
        ours = {m.header.stamp: m.pose.pose.position for m in self.get("laser_odometry/odom")}
        self.assertEqual([m.header.stamp for m in compared], sorted(ours))
        delta = 0.05 if self.has_wheels else 1e-9  # the second one goes by its laser alone
        for message in compared:
            self.assertAlmostEqual(message.pose.pose.position.x, ours[message.header.stamp].x,
                                   delta=delta)
        self.assertEqual(len(self.motions(63)), 63, "it publishes no motion")


if __name__ == "__main__":
    rospy.init_node("laser_odometry_test")
    rostest.rosrun("slam_tests", "laser_odometry", LaserOdometryTest, sys.argv)
