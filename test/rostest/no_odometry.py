#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A product that takes no odometry, on a robot whose driver publishes odom -> base_link or not."""

import math
import sys
import threading
import time
import unittest

from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from player import wait_for
from rosgraph_msgs.msg import Log
import rospy
import rostest
from sensor_msgs.msg import LaserScan
from still_robot import mount
from tf2_msgs.msg import TFMessage

WALL = 3.0  # [m], of a square room about the robot


def scan(stamp):
    """A turn of a laser in the middle of the room."""
    message = LaserScan(angle_min=-math.pi, angle_max=math.pi, angle_increment=math.pi / 180,
                        range_min=0.1, range_max=8.0)
    message.header.stamp = stamp
    message.header.frame_id = "laser"
    for i in range(361):
        angle = math.radians(i - 180)
        message.ranges.append(WALL / max(abs(math.cos(angle)), abs(math.sin(angle))))
    return message


def drivers_edge(stamp, x, heading):
    edge = TransformStamped(child_frame_id="base_link")
    edge.header.frame_id = "odom"
    edge.header.stamp = stamp
    edge.transform.translation.x = x
    edge.transform.rotation.z = math.sin(heading / 2)
    edge.transform.rotation.w = math.cos(heading / 2)
    return edge


class NoOdometryTest(unittest.TestCase):
    """The robot stands still. The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.lock = threading.Lock()
        cls.edges, cls.first, cls.poses, cls.lines = [], {}, 0, []
        cls.stamp = rospy.Time(1000)
        cls.scan = rospy.Publisher("scan", LaserScan, queue_size=100)
        cls.driver = rospy.Publisher("/tf", TFMessage, queue_size=100)
        cls.mount = rospy.Publisher("/tf_static", TFMessage, queue_size=10, latch=True)
        cls.mount.publish(TFMessage([mount("laser")]))
        cls.subscribers = [rospy.Subscriber("/tf", TFMessage, cls.keep, queue_size=1000),
                           rospy.Subscriber("pose", PoseWithCovarianceStamped, cls.count),
                           rospy.Subscriber("/rosout", Log, cls.read)]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0
                                             for p in (cls.scan, cls.mount)), 30)

    @classmethod
    def keep(cls, message):
        if message._connection_header["callerid"] == rospy.get_name():
            return
        with cls.lock:
            cls.edges += message.transforms
            for edge in message.transforms:
                cls.first.setdefault(edge.child_frame_id, time.monotonic())

    @classmethod
    def count(cls, _):
        cls.poses += 1

    @classmethod
    def read(cls, line):
        cls.lines.append(line.msg)

    def newest(self, parent, child):
        with self.lock:
            found = [e for e in self.edges
                     if e.header.frame_id == parent and e.child_frame_id == child]
        return found[-1] if found else None

    def play(self, scans, edge=None):
        before = self.poses
        for _ in range(scans):
            type(self).stamp += rospy.Duration(0.1)
            if edge:
                self.driver.publish(TFMessage([drivers_edge(self.stamp, *edge)]))
                time.sleep(0.05)
            self.scan.publish(scan(self.stamp))
            time.sleep(0.05)
        self.assertTrue(wait_for(lambda: self.poses >= before + scans), "a pose for each scan")

    def test_0_the_console_names_an_input_that_never_comes(self):
        self.assertTrue(self.connected)
        self.assertTrue(wait_for(lambda: any("waiting for scans on" in line for line in self.lines),
                                 20), self.lines)

    def test_1_without_a_driver_odometry_and_robot_are_one(self):
        self.play(5)
        self.assertTrue(wait_for(lambda: self.newest("odom", "base_link") or self.play(1), 20))
        self.assertEqual(self.newest("odom", "base_link").transform.translation.x, 0.0)
        self.assertGreater(self.first["base_link"] - self.first["odom"], 0.5,
                           "a driver has time to be heard first")
        self.assertLess(abs(self.newest("map", "odom").transform.translation.x), 0.05)

    def test_2_a_driver_keeps_its_transform_and_the_map_fits_it(self):
        self.play(3, edge=(2.0, math.pi / 2))
        with self.lock:
            self.edges.clear()
        self.play(5, edge=(2.0, math.pi / 2))
        self.assertIsNone(self.newest("odom", "base_link"), "it is the driver's alone")
        # map -> odom and the driver's odom -> base_link lead to where the robot is, the origin
        origin = self.newest("map", "odom").transform
        self.assertAlmostEqual(origin.translation.x, 0.0, delta=0.05)
        self.assertAlmostEqual(origin.translation.y, 2.0, delta=0.05)
        self.assertAlmostEqual(2 * math.atan2(origin.rotation.z, origin.rotation.w), -math.pi / 2,
                               delta=0.02)


if __name__ == "__main__":
    rospy.init_node("no_odometry_test")
    rostest.rosrun("slam_tests", "no_odometry", NoOdometryTest, sys.argv)
