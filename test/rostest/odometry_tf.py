#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot that tells its odometry only as the transform odom -> base_link of /tf."""

import copy
import math
import sys
import unittest

from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
import rospy
import rostest
from tf2_msgs.msg import TFMessage
from player import Player, wait_for


def as_transform(odometry):
    edge = TransformStamped(header=odometry.header, child_frame_id=odometry.child_frame_id)
    edge.transform.translation.x = odometry.pose.pose.position.x
    edge.transform.translation.y = odometry.pose.pose.position.y
    edge.transform.rotation = odometry.pose.pose.orientation
    return edge


class TransformPlayer(Player):
    """Nobody publishes `odom`; its messages go to /tf, among others and twice."""

    def advertise_odometry(self):
        return rospy.Publisher("/tf", TFMessage, queue_size=1000)

    def send(self, topic, message):
        if topic != "/odom":
            super().send(topic, message)
            return
        other = as_transform(message)
        other.child_frame_id = "arm"
        for _ in range(2):
            self.publishers[topic].publish(TFMessage([other, as_transform(message)]))


class OdometryTransformTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.player = TransformPlayer()

    def edges(self):
        """The (stamp, x) of odom -> base_link in /tf."""
        return [(edge.header.stamp, edge.transform.translation.x)
                for message in self.player.get("/tf") for edge in message.transforms
                if edge.header.frame_id == "odom" and edge.child_frame_id == "base_link"]

    def test_1_drives_the_filter_as_the_topic_does(self):
        self.assertTrue(self.player.connected)
        part = self.player.begin(observations=40)
        arrays = [m.header.stamp for topic, m in part if topic == "/observations"]
        self.assertEqual([p.header.stamp for p in self.player.get("pose")][:len(arrays)], arrays)
        odometry = [m for topic, m in part if topic == "/odom"]
        sent = {(m.header.stamp, m.pose.pose.position.x) for m in odometry}
        wait_for(lambda: set(self.edges()) >= sent)
        self.assertEqual(set(self.edges()), sent, "only the driver publishes this transform")
        end, last = self.player.get("pose")[-1].pose.pose.position, odometry[-1].pose.pose.position
        self.assertLess(math.hypot(end.x - last.x, end.y - last.y), 1.0)

    def test_2_gives_way_to_the_topic(self):
        topic = rospy.Publisher("odom", Odometry, queue_size=1000)
        self.assertTrue(wait_for(lambda: topic.get_num_connections() > 0))
        transforms = self.player.publishers["/odom"]
        part = self.player.part(40, 80)
        self.player.clear()
        for name, message in part:
            if name != "/odom":
                self.player.send(name, message)
                continue
            topic.publish(message)
            wrong = copy.deepcopy(message)
            wrong.header.stamp += rospy.Duration(0.001)
            wrong.pose.pose.position.x += 100.0
            transforms.publish(TFMessage([as_transform(wrong)]))
        arrays = sum(name == "/observations" for name, _ in part)
        self.assertTrue(wait_for(lambda: len(self.player.get("pose")) >= arrays))
        for pose in self.player.get("pose"):
            self.assertLess(abs(pose.pose.pose.position.x), 50.0)


if __name__ == "__main__":
    rospy.init_node("odometry_tf_test")
    rostest.rosrun("slam_tests", "odometry_tf", OdometryTransformTest, sys.argv)
