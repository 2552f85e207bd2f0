#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node: labels of a file and of the service, beside the ids, through a merge, saved."""
import pathlib
import sys
import time
import unittest

import rospy
import rostest
from slam_msgs.msg import Landmark, LandmarkLabels, LandmarkMap
from slam_msgs.srv import LabelLandmark
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray
import yaml

LARGE = 2**40  # an id that a marker cannot have


class LandmarkLabelsNode(unittest.TestCase):
    def setUp(self):
        self.labels, self.markers = {}, []
        rospy.Subscriber("landmark_labels", LandmarkLabels, self.take)
        rospy.Subscriber("landmark_label_markers", MarkerArray, self.take_markers)
        self.map = rospy.Publisher("landmarks", LandmarkMap, queue_size=1, latch=True)
        for name in ("label_landmark", "save_labels"):
            rospy.wait_for_service(name, 20)
        self.label = rospy.ServiceProxy("label_landmark", LabelLandmark)

    def take(self, message):
        self.labels = dict(zip(message.ids, message.labels))

    def take_markers(self, message):
        self.markers = [marker.text for marker in message.markers[1:]]

    def see(self, **places):
        message = LandmarkMap()
        message.header.frame_id = "map"
        message.landmarks = [Landmark(id=int(name[1:]), x=x, y=y)
                             for name, (x, y) in places.items()]
        self.map.publish(message)

    def expect(self, labels):
        end = time.monotonic() + 20
        expected = labels, list(labels.values())
        while time.monotonic() < end and (self.labels, self.markers) != expected:
            time.sleep(0.05)
        self.assertEqual((self.labels, self.markers), expected)

    def test_keeps_labels(self):
        self.assertIn("there are: none yet", self.label(1, "a").message)
        self.see(_1=(0, 0), _3=(2, 0), _4=(5, 1))
        self.expect({3: "door", 4: "extinguisher"})
        self.assertTrue(self.label(1, "desk").success)
        self.expect({1: "desk", 3: "door", 4: "extinguisher"})
        refused = self.label(3, "gate")
        self.assertFalse(refused.success)
        self.assertIn("called 'door' already", refused.message)
        self.assertIn("there is no landmark 9", self.label(9, "x").message)
        self.see(_1=(0, 0), **{f"_{LARGE}": (2.2, 0)}, _4=(5, 1))  # it and 3 were the same
        self.expect({1: "desk", 4: "extinguisher", LARGE: "door"})
        self.expect_saved()

    def expect_saved(self):
        answer = rospy.ServiceProxy("save_labels", Trigger)()
        self.assertTrue(answer.success, answer.message)
        path = pathlib.Path(rospy.get_param("~folder")) / "labels.yaml"
        self.assertIn(str(path), answer.message)
        saved = yaml.safe_load(path.read_text(encoding="utf-8"))["landmarks"]
        self.assertEqual({entry["id"]: entry["label"] for entry in saved},
                         {1: "desk", 4: "extinguisher", LARGE: "door"})


if __name__ == "__main__":
    rospy.init_node("landmark_labels_test")
    rostest.rosrun("slam_labels", "labels_are_kept", LandmarkLabelsNode, sys.argv)
