#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What laser odometry publishes, with walls around it, blind, and beside another odometry."""

import copy
import math
import sys
import time
import unittest

from motion_source import MotionSource, simulated
from nav_msgs.msg import Odometry
import numpy
from player import wait_for
import rospy
import rostest
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

SECONDS = 8
TOPICS = {"/scan": LaserScan, "/tf_static": TFMessage}


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


class LaserOdometryTest(MotionSource, unittest.TestCase):
    SOURCE = "laser"

    @classmethod
    def setUpClass(cls):
        cls.has_wheels = rospy.get_param("~odometry") == "laser_wheel"
        kinds = {**TOPICS, **({"/odom": Odometry} if cls.has_wheels else {})}
        log = simulated(SECONDS, "odom,scan")
        cls.truth = {m.header.stamp: planar(m.pose) for topic, m in log
                     if topic == "/ground_truth/pose"}
        cls.steps = cls.split([(topic, m) for topic, m in log if topic in kinds])
        cls.connect(kinds, [next(entry for entry in log if entry[0] == "/tf_static")])
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

    def test_1_every_scan_after_the_first_yields_a_motion(self):
        self.assertTrue(self.connected)
        self.send(30)
        self.assert_motions_end_at(self.stamps()[1:])

    def test_2_odometry_and_transform_tell_the_same_way(self):
        self.assert_odometry_and_transform_tell_the_way(29)

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
        self.assertTrue(self.has_warned("do not tell the robot's motion"))
        self.send(5)
        self.assertLess(self.motions(59)[-1].covariance[0], 1e-4)
        self.assertLess(self.error(), 0.05)
        self.assertTrue(wait_for(lambda: self.values().get("unmatched") == "5"), self.values())

    def test_5_another_odometry_keeps_its_transform(self):
        self.let_another_publish_the_transform(self.stamps()[-1])
        self.send(4)
        self.assert_keeps_a_frame_of_its_own(63)

    def test_6_beside_the_products_odometry_a_second_one_only_tells_its_own(self):
        # the second one goes by its laser alone
        self.assert_the_second_one_tells_only_its_own(63, 0.05 if self.has_wheels else 1e-9)


if __name__ == "__main__":
    rospy.init_node("laser_odometry_test")
    rostest.rosrun("slam_tests", "laser_odometry", LaserOdometryTest, sys.argv)
