#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What visual odometry publishes, with a good ceiling, in the dark, and beside another odometry."""

import os
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import zlib

from catkin.find_in_workspaces import find_in_workspaces
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
import numpy
from player import wait_for
import rosbag
from rosgraph_msgs.msg import Log
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from slam_msgs.msg import Motion
from tf2_msgs.msg import TFMessage

SECONDS = 4
TOPICS = {"/ceiling_camera/image_raw/compressed": CompressedImage,
          "/ceiling_camera/camera_info": CameraInfo, "/tf_static": TFMessage}
IMAGE = "/ceiling_camera/image_raw/compressed"
OUTPUTS = {"motion": Motion, "visual_odometry/odom": Odometry, "compared/odom": Odometry,
           "/tf": TFMessage, "/rosout": Log, "/diagnostics": DiagnosticArray}


def read_log():
    """Returns the (topic, message) of a simulated drive."""
    program = find_in_workspaces(["libexec"], "slam_sim", "slam_sim", first_match_only=True)[0]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "drive.bag")
        subprocess.run([program, path, "--duration", str(SECONDS), "--only", "ceiling_camera"],
                       check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(path) as bag:
            return [(topic, message) for topic, message, _ in
                    bag.read_messages(topics=list(TOPICS))]


def png(width, height, gray):
    """An even picture."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(
            ">I", zlib.crc32(kind + data))
    rows = (b"\0" + bytes([gray]) * width) * height
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def dark(message):
    """A picture of the lens's cap with the stamp of a message."""
    return CompressedImage(header=message.header, format="png", data=png(640, 480, 8))


class VisualTest(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.log = read_log()
        cls.images = [message for topic, message in cls.log if topic == IMAGE]
        cls.lock = threading.Lock()
        cls.received = {topic: [] for topic in OUTPUTS}
        cls.publishers = {topic: rospy.Publisher(topic, kind, queue_size=100,
                                                 latch=topic == "/tf_static")
                          for topic, kind in TOPICS.items()}
        cls.transforms = rospy.Publisher("/tf", TFMessage, queue_size=10)
        cls.subscribers = [rospy.Subscriber(topic, kind, cls.keep, topic, queue_size=1000)
                           for topic, kind in OUTPUTS.items()]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0
                                             for p in cls.publishers.values()), 30)
        cls.connected &= wait_for(lambda: all(s.get_num_connections() > 0
                                              for s in cls.subscribers[:3]), 30)
        time.sleep(0.5)  # a nodelet advertises before it subscribes
        for topic, message in cls.log:
            if topic != IMAGE:
                cls.publishers[topic].publish(message)
        time.sleep(1.0)
        cls.sent = 0

    @classmethod
    def keep(cls, message, topic):
        with cls.lock:
            cls.received.setdefault(topic, []).append(message)

    def get(self, topic):
        with self.lock:
            return list(self.received.get(topic, []))

    def send(self, count, change=lambda message: message):
        for message in self.images[self.sent:self.sent + count]:
            self.publishers[IMAGE].publish(change(message))
            time.sleep(0.03)
        type(self).sent += count

    def motions(self, count):
        self.assertTrue(wait_for(lambda: len(self.get("motion")) >= count),
                        f"{len(self.get('motion'))} motions came")
        return self.get("motion")

    def test_1_every_image_after_the_first_yields_a_motion(self):
        self.assertTrue(self.connected)
        self.send(20)
        motions = self.motions(19)
        self.assertEqual([m.sequence for m in motions], list(range(19)))
        self.assertEqual([m.end for m in motions], [i.header.stamp for i in self.images[1:20]])
        for motion in motions:
            covariance = numpy.array(motion.covariance).reshape(3, 3)
            self.assertGreater(numpy.linalg.eigvalsh(covariance).min(), 0)
        self.assertEqual({(m.header.frame_id, m.child_frame_id) for m in motions},
                         {("odom", "base_link")})

    def test_2_odometry_and_transform_tell_the_same_way(self):
        self.assertTrue(wait_for(lambda: len(self.get("visual_odometry/odom")) >= 19))
        odometry, end = self.get("visual_odometry/odom")[-1], self.get("motion")[-1].odometry_end
        self.assertEqual((odometry.header.frame_id, odometry.child_frame_id),
                         ("odom", "base_link"))
        self.assertAlmostEqual(odometry.pose.pose.position.x, end.x)
        self.assertAlmostEqual(odometry.pose.pose.position.y, end.y)
        self.assertGreater(odometry.pose.covariance[0], 0)
        edges = [t for m in self.get("/tf") for t in m.transforms
                 if t.child_frame_id == "base_link"]
        self.assertAlmostEqual(edges[-1].transform.translation.x, end.x)
        stamps = [e.header.stamp for e in edges]
        self.assertTrue(all(a < b for a, b in zip(stamps, stamps[1:])))

    def test_3_matches_are_drawn_while_somebody_looks(self):
        look = rospy.Subscriber("visual_odometry/image", Image, self.keep, "drawn", queue_size=100)
        self.assertTrue(wait_for(lambda: look.get_num_connections() > 0))
        self.send(8)
        self.assertTrue(wait_for(lambda: len(self.get("drawn")) > 0))
        look.unregister()
        self.assertEqual(self.get("drawn")[-1].encoding, "bgr8")

    def values(self):
        """The newest diagnostic of the nodelet."""
        for array in reversed(self.get("/diagnostics")):
            for status in array.status:
                if status.name.startswith("visual_odometry"):
                    return {"message": status.message,
                            **{entry.key: entry.value for entry in status.values}}
        return {}

    def test_4_diagnostics_tell_how_well_it_goes(self):
        self.assertTrue(wait_for(lambda: self.values().get("message") == "running"), self.values())
        self.assertTrue(wait_for(lambda: float(self.values().get("inliers", 0)) > 15))
        values = self.values()
        self.assertAlmostEqual(float(values["scale"]), 1.0, delta=0.01)
        for name in ("features", "matches", "keyframes", "rate [1/s]"):
            self.assertGreater(float(values[name]), 0, name)

    def test_5_dark_images_are_told_and_time_goes_on(self):
        self.send(6, dark)
        self.assertEqual(len(self.motions(33)), 33)
        self.assertTrue(wait_for(lambda: any("the last velocity is used meanwhile" in log.msg
                                             for log in self.get("/rosout"))))
        self.send(4)
        last = self.motions(37)[-1]
        self.assertLess(last.covariance[0], 1e-4)

    def test_6_another_odometry_keeps_its_transform(self):
        edge = TransformStamped(child_frame_id="base_link")
        edge.header.frame_id = "odom"
        edge.header.stamp = self.images[self.sent].header.stamp
        edge.transform.rotation.w = 1.0
        self.transforms.publish(TFMessage([edge]))
        time.sleep(0.5)
        self.send(4)
        self.assertEqual(self.motions(41)[-1].header.frame_id, "visual_odom")
        self.assertTrue(wait_for(lambda: any("visual_odom" in log.msg
                                             for log in self.get("/rosout"))))

    def test_7_beside_the_products_odometry_a_second_one_only_tells_its_own(self):
        self.assertTrue(wait_for(lambda: len(self.get("compared/odom")) >= 41),
                        len(self.get("compared/odom")))
        compared = self.get("compared/odom")
        self.assertEqual({(m.header.frame_id, m.child_frame_id) for m in compared},
                         {("visual_odom", "base_link")})
        ours = {m.header.stamp: m.pose.pose.position for m in self.get("visual_odometry/odom")}
        self.assertEqual([m.header.stamp for m in compared], sorted(ours))
        for message in compared:
            self.assertAlmostEqual(message.pose.pose.position.x, ours[message.header.stamp].x)
        self.assertEqual(len(self.motions(41)), 41, "it publishes no motion")


if __name__ == "__main__":
    rospy.init_node("visual_test")
    rostest.rosrun("slam_tests", "visual", VisualTest, sys.argv)
