#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Maps and poses that cannot be used are told of, and the next good ones lead to a goal."""

import math
import sys
import time
import unittest

from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Log
import rospy
import rostest

EDGE = 80  # of the map [cells]


def room():
    """Returns a map of 4 m x 4 m, free up to its edge."""
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.resolution, grid.info.width, grid.info.height = 0.05, EDGE, EDGE
    grid.info.origin.orientation.w = 1.0
    grid.data = [0] * (EDGE * EDGE)
    return grid


def pose(x=2.0, y=2.0, frame="map"):
    message = PoseWithCovarianceStamped()
    message.header.frame_id = frame
    message.pose.pose.position.x, message.pose.pose.position.y = x, y
    message.pose.pose.orientation.w = 1.0
    return message


class BadInput(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.told, cls.goals, cls.second = [], [], 0
        cls.subscribers = [
            rospy.Subscriber("/rosout", Log, lambda message: cls.told.append(message.msg)),
            rospy.Subscriber("elsewhere/goal", PoseStamped, cls.goals.append)]
        cls.map = rospy.Publisher("map", OccupancyGrid, queue_size=10)
        cls.pose = rospy.Publisher("pose", PoseWithCovarianceStamped, queue_size=10)
        end = time.monotonic() + 20
        while time.monotonic() < end and not (cls.map.get_num_connections()
                                              and cls.pose.get_num_connections()):
            time.sleep(0.1)

    def send(self, grid, estimate):
        """Sends both, two seconds of stamps after those before."""
        type(self).second += 2
        self.map.publish(grid)
        time.sleep(0.3)  # they are two topics
        estimate.header.stamp = rospy.Time(100 + self.second)
        self.pose.publish(estimate)
        time.sleep(0.3)

    def expect(self, words):
        end = time.monotonic() + 5
        while time.monotonic() < end and not any(words in text for text in self.told):
            time.sleep(0.1)
        self.assertTrue(any(words in text for text in self.told), self.told)

    def test_1_a_map_that_is_turned_is_left_out(self):
        grid = room()
        grid.info.origin.orientation.z = 0.7
        self.send(grid, pose())
        self.expect("the map's origin is turned or no number")
        self.assertEqual(self.goals, [])

    def test_2_a_map_or_pose_that_is_none_is_told(self):
        grid = room()
        grid.data = grid.data[1:]
        self.send(grid, pose())
        self.expect("its data do not fill its width and height")
        self.send(room(), pose(x=math.nan))
        self.expect("the pose cannot be used: it is not a number")
        self.send(room(), pose(frame="odom"))
        self.expect("the pose is in the frame 'odom', the map in 'map'")
        self.send(room(), pose(x=-20.0))
        self.expect("outside of the map's known free space")
        self.assertEqual(self.goals, [])

    def test_3_good_ones_lead_to_a_goal(self):
        self.send(room(), pose())
        time.sleep(0.5)
        self.assertEqual(len(self.goals), 1)
        self.assertEqual(self.goals[0].header.frame_id, "map")
        self.assertTrue(math.isfinite(self.goals[0].pose.position.x))

    def test_4_a_goal_to_which_nobody_drives_is_left_out(self):
        for _ in range(4):
            self.send(room(), pose())
        self.expect("the robot has come no nearer to the goal")
        self.assertEqual(len(self.goals), 2)
        self.assertNotEqual(self.goals[0].pose.position, self.goals[1].pose.position)


if __name__ == "__main__":
    rospy.init_node("bad_input_test")
    rostest.rosrun("slam_active", "bad_input", BadInput, sys.argv)
