#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a back-end tells others beyond its pose: events, and the graph as markers for rviz."""

import math
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import Odometry
from player import wait_for
import rosbag
import rospy
import rostest
from sensor_msgs.msg import LaserScan
from slam_msgs.msg import Event
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

SECONDS = 8
TOPICS = {"/odom": Odometry, "/scan": LaserScan, "/tf_static": TFMessage}
PUT = 30.0  # by which the robot is put aside [m], out of the map; 0.01 m/s would need 50 min


def read_simulation():
    """Returns the (topic, message) of some seconds in the office."""
    program = find_in_workspaces(["libexec"], "slam_sim", "slam_sim", first_match_only=True)[0]
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "office.bag"
        subprocess.run([program, path, "--duration", str(SECONDS), "--only", "odom,scan"],
                       check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(str(path)) as bag:
            return [(topic, message) for topic, message, _ in
                    bag.read_messages(topics=list(TOPICS))]


class EventsTest(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        log = read_simulation()
        cls.halves = [log[:len(log) // 2], log[len(log) // 2:]]
        cls.events, cls.markers, cls.poses, cls.corrections = [], [], [], []
        rospy.Subscriber("events", Event, cls.events.append)
        rospy.Subscriber("graph_markers", MarkerArray, cls.markers.append)
        rospy.Subscriber("pose", PoseWithCovarianceStamped, cls.poses.append)
        rospy.Subscriber("/tf", TFMessage, cls.note)
        cls.publishers = {topic: rospy.Publisher(topic, kind, queue_size=1000,
                                                 latch=topic == "/tf_static")
                          for topic, kind in TOPICS.items()}
        cls.initialpose = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        senders = [*cls.publishers.values(), cls.initialpose]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0 for p in senders), 30)

    @classmethod
    def note(cls, message):
        cls.corrections += [edge.transform.translation for edge in message.transforms
                            if edge.header.frame_id == "map"]

    def play(self, half):
        for topic, message in self.halves[half]:
            self.publishers[topic].publish(message)
            time.sleep(0.003)
        last = [m.header.stamp for topic, m in self.halves[half] if topic == "/scan"][-2]
        self.assertTrue(wait_for(lambda: self.poses and self.poses[-1].header.stamp >= last, 20))

    def test_1_a_drive_without_trouble_has_a_graph_and_no_events(self):
        self.assertTrue(self.connected)
        self.play(0)
        self.assertTrue(wait_for(lambda: self.markers, 10))
        self.assertEqual(self.events, [])
        markers = {marker.ns: marker for marker in self.markers[-1].markers}
        self.assertEqual(set(markers), {"nodes", "submaps", "motion", "sightings", "loops",
                                        "waiting_loops"})
        self.assertEqual(markers["motion"].type, Marker.LINE_LIST)
        self.assertEqual(markers["nodes"].header.frame_id, "map")
        self.assertEqual(len(markers["motion"].points), 2 * (len(markers["nodes"].points) - 1))
        self.assertEqual(markers["sightings"].action, Marker.DELETE, "it saw no landmark")

    def test_2_who_listens_is_told_that_the_robot_was_put_elsewhere(self):
        there = self.poses[-1]
        there.header.frame_id = "map"
        there.pose.pose.position.x += PUT
        there.pose.covariance = [0.01 if i % 7 == 0 else 0.0 for i in range(36)]
        before = self.corrections[-1]
        steps = len(self.poses)
        self.initialpose.publish(there)
        time.sleep(0.5)  # it comes on a connection of its own
        self.play(1)
        self.assertTrue(wait_for(lambda: self.events, 10))
        event = self.events[0]
        self.assertEqual((event.kind, event.reason), (Event.JUMP, "the robot was put there"))
        self.assertEqual(event.header.frame_id, "map")
        self.assertGreaterEqual(event.header.stamp, self.poses[steps].header.stamp)
        self.assertAlmostEqual(event.distance, PUT, delta=1.0)
        after = self.corrections[-1]
        moved = math.hypot(after.x - before.x, after.y - before.y)
        self.assertGreater(moved, 0.5 * PUT, "jump_limit does not hold where the robot is put")


if __name__ == "__main__":
    rospy.init_node("events_test")
    rostest.rosrun("slam_tests", "events", EventsTest, sys.argv)
