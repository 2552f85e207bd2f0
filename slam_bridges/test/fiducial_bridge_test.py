#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node beside a product without a detector of its own: detections in, landmarks out."""
import subprocess
import sys
import time
import unittest

from detections_made import APRILTAG, apriltag_array, CLASSES
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.msg import Odometry
import rospy
import rostest
from slam_msgs.msg import LandmarkMap, LandmarkObservationArray
from std_msgs.msg import String
from test_conversion import LOOKS_AHEAD, transform
from tf2_msgs.msg import TFMessage

WITHIN = 20.0  # [s]
MARKERS = [(11, (0.5, 0.0, 2.0)), (12, (-0.5, 0.0, 3.0))]


def wait_for(condition):
    """Waits by the wall clock; returns whether the condition came true."""
    end = time.monotonic() + WITHIN
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


class FiducialBridgeTest(unittest.TestCase):
    """The robot stands still. The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.received = {"observations": [], "landmarks": [], "/diagnostics": []}
        cls.seen = rospy.Publisher("tag_detections", CLASSES[APRILTAG][APRILTAG], queue_size=100)
        cls.odom = rospy.Publisher("odom", Odometry, queue_size=100)
        cls.mounts = rospy.Publisher("/tf_static", TFMessage, queue_size=10, latch=True)
        cls.subscribers = [rospy.Subscriber(topic, kind, cls.received[topic].append) for topic, kind
                           in (("observations", LandmarkObservationArray),
                               ("landmarks", LandmarkMap), ("/diagnostics", DiagnosticArray))]
        cls.stamp = rospy.Time(1000)
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0 for p in
                                             (cls.seen, cls.odom, cls.mounts)))

    def setUp(self):
        self.assertTrue(self.connected)

    def play(self, count):
        """Odometry of a robot that stands, and detections."""
        for _ in range(count):
            type(self).stamp += rospy.Duration(0.05)
            message = Odometry(child_frame_id="base_link")
            message.header.frame_id, message.header.stamp = "odom", self.stamp
            message.pose.pose.orientation.w = 1.0
            self.odom.publish(message)
            self.seen.publish(apriltag_array(self.stamp, MARKERS))
            time.sleep(0.02)

    def state(self):
        """The bridge's newest diagnostic: message and values."""
        for array in reversed(self.received["/diagnostics"]):
            for status in array.status:
                if status.name == "fiducial_bridge: state":
                    return {"message": status.message, "level": status.level,
                            **{each.key: each.value for each in status.values}}
        return {}

    def test_1_says_what_is_missing(self):
        self.play(5)
        self.assertTrue(wait_for(lambda: "no_mount" in self.state()), self.state())
        self.assertIn("no transform leads from base_link to camera_optical_frame",
                      self.state()["message"])
        self.assertEqual(self.received["observations"], [])

    def test_2_the_product_maps_what_is_detected(self):
        self.mounts.publish(transform("base_link", "camera_optical_frame", (0.1, 0.0, 0.5),
                                      LOOKS_AHEAD))
        time.sleep(0.5)
        self.play(40)
        self.assertTrue(wait_for(lambda: len(self.received["observations"]) >= 40))
        first = self.received["observations"][0]
        self.assertEqual([z.id for z in first.observations], [11, 12])
        self.assertAlmostEqual(first.sensor_pose.x, 0.1)
        self.assertTrue(wait_for(lambda: self.received["landmarks"] or self.play(1)))
        found = {each.id: (each.x, each.y) for each in self.received["landmarks"][-1].landmarks}
        for identity, (right, _, ahead) in MARKERS:
            self.assertAlmostEqual(found[identity][0], ahead + 0.1, delta=0.02)
            self.assertAlmostEqual(found[identity][1], -right, delta=0.02)

    def test_3_another_type_on_the_topic(self):
        other = rospy.Publisher("tag_detections_of_another_kind", String, queue_size=10, latch=True)
        other.publish("no detection")
        # a second bridge: one topic has one type
        node = subprocess.Popen(["rosrun", "slam_bridges", "fiducial_bridge", "__name:=second",
                                 "tag_detections:=tag_detections_of_another_kind"],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        try:
            self.assertTrue(wait_for(lambda: any(
                "carries std_msgs/String; a bridge takes" in status.message
                for array in list(self.received["/diagnostics"]) for status in array.status)))
        finally:
            node.terminate()
            node.wait()

    def test_4_says_that_nothing_comes(self):
        self.assertTrue(wait_for(lambda: self.state().get("message", "").startswith(
            "waiting for detections on /tag_detections")), self.state())


if __name__ == "__main__":
    rospy.init_node("fiducial_bridge_test")
    rostest.rosrun("slam_bridges", "fiducial_bridge", FiducialBridgeTest, sys.argv)
