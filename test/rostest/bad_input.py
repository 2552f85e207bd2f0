#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad data leads to a warning that names topic and cause, never to a crash, a NaN or silence."""

import copy
import math
import sys
import unittest

from geometry_msgs.msg import PoseWithCovarianceStamped
import rospy
import rostest
from std_srvs.srv import Trigger
from player import Player, wait_for


class BadInputTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.player = Player()

    def setUp(self):
        self.player.begin(5)
        self.rest = self.player.part(6, 12)

    def spoil(self, topic, change):
        """Plays the rest with its first message of a topic changed; poses must stay numbers."""
        change(next(message for name, message in self.rest if name == topic))
        self.player.play(self.rest)
        self.assertTrue(wait_for(lambda: len(self.player.get("pose")) >= 10))
        for pose in self.player.get("pose"):
            self.assertTrue(all(map(math.isfinite, pose.pose.covariance)))
            self.assertTrue(math.isfinite(pose.pose.pose.position.x))

    def assert_warned(self, *texts):
        def warned():
            return any(all(text in line for text in texts) for line in self.player.warnings())
        self.assertTrue(wait_for(warned, 6), f"{texts} not in {self.player.warnings()}")

    def test_observation_with_nan(self):
        def change(array):
            array.observations[0].range = float("nan")
        self.spoil("/observations", change)
        self.assert_warned("observations", "not a number")
        self.assertTrue(wait_for(
            lambda: self.player.counters("slam_backend").get("invalid_observation") == "1"))

    def test_observation_with_negative_range(self):
        def change(array):
            array.observations[0].range = -1.0
        self.spoil("/observations", change)
        self.assert_warned("observations", "range that is not positive")

    def test_observation_with_a_covariance_that_is_none(self):
        def change(array):
            array.observations[0].covariance = [1.0, 2.0, 2.0, 1.0]
        self.spoil("/observations", change)
        self.assert_warned("observations", "not positive definite")

    def test_observation_with_an_absurdly_large_covariance(self):
        def change(array):
            array.observations[0].covariance = [1.7e308, 0.0, 0.0, 1e-4]
        self.spoil("/observations", change)
        self.assert_warned("observations", "standard deviations")

    def test_array_of_a_hundred_thousand_new_landmarks(self):
        def change(array):
            first = array.observations[0]
            for landmark in range(100000):
                wild = copy.copy(first)
                wild.id = 1000 + landmark
                array.observations.append(wild)
        self.spoil("/observations", change)
        self.assert_warned("observations", "more than the 500")
        self.assertTrue(wait_for(lambda: int(self.player.counters("slam_backend").get(
            "observations_beyond_limit", "0")) > 99000))

    def test_sensor_pose_with_nan(self):
        def change(array):
            array.sensor_pose.x = float("nan")
        self.spoil("/observations", change)
        self.assert_warned("observations", "sensor pose")

    def test_odometry_with_nan(self):
        def change(odometry):
            odometry.pose.pose.position.x = float("nan")
        self.spoil("/odom", change)
        self.assert_warned("wheel_odometry", "odom", "not a number")

    def test_odometry_with_a_quaternion_of_zeros(self):
        def change(odometry):
            odometry.pose.pose.orientation.w = odometry.pose.pose.orientation.z = 0.0
        self.spoil("/odom", change)
        self.assert_warned("wheel_odometry", "odom", "quaternion of its pose is zero")

    def test_frame_that_changes_on_the_way(self):
        def change(odometry):
            odometry.header.frame_id = "wheels"
        self.spoil("/odom", change)
        self.assert_warned("wheel_odometry", "odom", "frames changed to wheels")

    def test_stamp_that_goes_back(self):
        def change(array):
            array.header.stamp -= rospy.Duration(0.55)
        self.spoil("/observations", change)
        self.assertTrue(wait_for(lambda: self.player.counters("slam_backend").get("late") == "1"))

    def test_initialpose_in_another_frame(self):
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id = "odom"
        self.player.publishers["initialpose"].publish(pose)
        self.assert_warned("initialpose", "'odom'", "'map'")

    def test_clock_that_jumps_back_resets_with_one_warning(self):
        self.player.play(self.player.part(6, 100))
        wait_for(lambda: len(self.player.get("pose")) >= 100)
        self.player.clear()
        self.player.now = rospy.Time(0)
        self.player.play(self.player.part(0, 20))
        self.assertTrue(wait_for(lambda: len(self.player.get("pose")) >= 15))
        self.assertLess(len(self.player.get("path")[-1].poses), 30)
        wait_for(lambda: False, 1.5)  # a second warning would have come by then
        warned = [line for line in self.player.warnings() if "anew" in line]
        self.assertEqual(len(warned), 1, warned)

    def test_clock_that_jumps_far_and_back_ends_nothing(self):
        """ROS's times and durations hold 32 bit of seconds: their differences may not fit."""
        self.player.play(self.rest)
        for seconds in (4000000000, 4294967295, 3000000000, 50):
            self.player.turn_back(rospy.Time(seconds))
            for topic, message in self.player.part(12, 14):
                self.player.publishers[topic].publish(message)
            wait_for(lambda: False, 0.5)
        self.player.begin(5)
        self.assertTrue(rospy.ServiceProxy("reset", Trigger)().success)


if __name__ == "__main__":
    rospy.init_node("bad_input_test")
    rostest.rosrun("slam_tests", "bad_input", BadInputTest, sys.argv)
