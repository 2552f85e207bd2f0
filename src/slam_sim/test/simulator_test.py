#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The live simulator: what it publishes, and that it obeys cmd_vel."""

import math
import sys
import unittest

from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, LaserScan
from slam_msgs.msg import LandmarkMap
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

TIMEOUT = 20  # s


class Topic:
    """Collects the messages of a topic."""

    def __init__(self, name, kind):
        self.messages = []
        self.subscriber = rospy.Subscriber(name, kind, self.messages.append, queue_size=1000)

    def stamps_since(self, time):
        return [m.header.stamp for m in list(self.messages) if m.header.stamp >= time]

    def rate_since(self, time):
        stamps = self.stamps_since(time)
        return (len(stamps) - 1) / (stamps[-1] - stamps[0]).to_sec() if len(stamps) > 1 else 0.0


def wait_for(condition):
    end = rospy.get_time() + TIMEOUT
    while not condition() and rospy.get_time() < end:
        rospy.sleep(0.05)
    return condition()


class SimulatorTest(unittest.TestCase):
    def test_says_once_who_and_where_everything_is(self):
        robot = rospy.wait_for_message("robot", String, TIMEOUT)
        self.assertEqual(robot.data, "sim_segway")
        landmarks = rospy.wait_for_message("ground_truth/landmarks", LandmarkMap, TIMEOUT)
        self.assertEqual([mark.id for mark in landmarks.landmarks], list(range(12)))
        mounts = rospy.wait_for_message("/tf_static", TFMessage, TIMEOUT)
        self.assertIn("camera_optical_frame", [t.child_frame_id for t in mounts.transforms])

    def test_publishes_every_stream_and_images_only_when_asked(self):
        odom, scan = Topic("odom", Odometry), Topic("scan", LaserScan)
        info, image = Topic("camera/camera_info", CameraInfo), Topic("camera/image_raw", Image)
        self.assertTrue(wait_for(lambda: len(image.messages) > 2))
        start = rospy.Time.now()
        rospy.sleep(3.0)
        self.assertAlmostEqual(odom.rate_since(start), 50, delta=5)
        self.assertAlmostEqual(scan.rate_since(start), 10, delta=1.5)
        self.assertAlmostEqual(info.rate_since(start), 10, delta=2)
        self.assertGreater(image.rate_since(start), 2)
        self.assertEqual((image.messages[0].width, image.messages[0].height,
                          image.messages[0].encoding), (640, 480, "mono8"))
        self.assertEqual(len(scan.messages[0].ranges), 682)
        compressed = rospy.wait_for_message("camera/image_raw/compressed", CompressedImage, TIMEOUT)
        self.assertEqual(bytes(compressed.data[:2]), b"\xff\xd8")  # a JPEG

    def test_stands_still_then_obeys_and_stops_after_the_last_command(self):
        truth, odom = Topic("ground_truth/pose", PoseStamped), Topic("odom", Odometry)
        self.assertTrue(wait_for(lambda: len(truth.messages) > 50))
        first, last = truth.messages[0].pose.position, truth.messages[-1].pose.position
        self.assertEqual((first.x, first.y), (last.x, last.y))
        command = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self.assertTrue(wait_for(lambda: command.get_num_connections() > 0))
        twist = Twist()
        twist.linear.x = 0.3
        for _ in range(10):
            command.publish(twist)
            rospy.sleep(0.1)
        self.assertAlmostEqual(odom.messages[-1].twist.twist.linear.x, 0.3, delta=0.05)
        rospy.sleep(1.5)
        at_rest = truth.messages[-1].pose.position
        way = math.hypot(at_rest.x - first.x, at_rest.y - first.y)
        self.assertGreater(way, 0.2)
        self.assertLess(way, 0.8)
        rospy.sleep(0.2)
        self.assertEqual(truth.messages[-1].pose.position.x, at_rest.x)


if __name__ == "__main__":
    rospy.init_node("live_simulator")
    rostest.rosrun("slam_sim", "live_simulator", SimulatorTest, sys.argv)
