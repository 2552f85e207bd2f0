#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The point map is of the frame that the back-end's map has."""

import math
import pathlib
import sys
import tempfile

from geometry_msgs.msg import PoseWithCovarianceStamped
from player import wait_for
import rospy
import rostest
from slam_msgs.srv import LoadMap, SaveMap
from still_robot import mount, StillRobot
from tf2_msgs.msg import TFMessage

AWAY = 10.0  # [m]


class PointMapTest(StillRobot):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.file = str(pathlib.Path(folder.name) / "landmarks.yaml")
        cls.placed = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        cls.connected &= wait_for(lambda: cls.placed.get_num_connections() > 0, 30)
        cls.transforms.publish(TFMessage([mount("laser")]))

    def place(self, x):
        """Puts the robot elsewhere, and waits until it is there."""
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id = "map"
        pose.pose.pose.position.x = x
        pose.pose.pose.orientation.w = 1.0
        for i in range(6):
            pose.pose.covariance[7 * i] = 1e-6
        self.placed.publish(pose)
        time_is_up = rospy.get_time() + 10
        while not any(abs(p.pose.pose.position.x - x) < 0.1 for p in self.get("pose")):
            self.assertLess(rospy.get_time(), time_is_up, "the robot is not where it was put")
            self.play(1)
            rospy.sleep(0.1)

    def call(self, name, kind, **request):
        answer = rospy.ServiceProxy(name, kind)(**request)
        self.assertTrue(answer.success, answer.message)

    def test_begins_anew_when_a_map_of_another_frame_is_loaded(self):
        self.begin_anew()
        self.place(AWAY)
        self.call("save_map", SaveMap, path=self.file)
        self.begin_anew()
        self.play(5)
        self.assert_point(2.0, 0.0)
        self.call("load_map", LoadMap, path=self.file)
        rospy.sleep(0.3)
        self.play(5)
        self.assert_point(AWAY + 2.0, 0.0)
        old = [point for point in self.points() if math.hypot(*point) < AWAY / 2]
        self.assertEqual(old, [], "points of the frame that was")


if __name__ == "__main__":
    rospy.init_node("point_map_test")
    rostest.rosrun("slam_tests", "point_map", PointMapTest, sys.argv)
