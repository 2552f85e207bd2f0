#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What visual odometry publishes, with a good ceiling, in the dark, and beside another odometry."""

import struct
import sys
import time
import unittest
import zlib

from motion_source import MotionSource, simulated
from player import wait_for
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from tf2_msgs.msg import TFMessage

SECONDS = 4
TOPICS = {"/ceiling_camera/image_raw/compressed": CompressedImage,
          "/ceiling_camera/camera_info": CameraInfo, "/tf_static": TFMessage}
IMAGE = "/ceiling_camera/image_raw/compressed"


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


class VisualTest(MotionSource, unittest.TestCase):
    SOURCE = "visual"

    @classmethod
    def setUpClass(cls):
        log = [entry for entry in simulated(SECONDS, "ceiling_camera") if entry[0] in TOPICS]
        cls.images = [message for topic, message in log if topic == IMAGE]
        cls.connect(TOPICS, [entry for entry in log if entry[0] != IMAGE])
        cls.sent = 0

    def send(self, count, change=lambda message: message):
        for message in self.images[self.sent:self.sent + count]:
            self.publishers[IMAGE].publish(change(message))
            time.sleep(0.03)
        type(self).sent += count

    def test_1_every_image_after_the_first_yields_a_motion(self):
        self.assertTrue(self.connected)
        self.send(20)
        self.assert_motions_end_at([image.header.stamp for image in self.images[1:20]])

    def test_2_odometry_and_transform_tell_the_same_way(self):
        self.assert_odometry_and_transform_tell_the_way(19)

    def test_3_matches_are_drawn_while_somebody_looks(self):
        look = rospy.Subscriber("visual_odometry/image", Image, self.keep, "drawn", queue_size=100)
        self.assertTrue(wait_for(lambda: look.get_num_connections() > 0))
        self.send(8)
        self.assertTrue(wait_for(lambda: len(self.get("drawn")) > 0))
        look.unregister()
        self.assertEqual(self.get("drawn")[-1].encoding, "bgr8")

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
        self.assertTrue(self.has_warned("the last velocity is used meanwhile"))
        self.send(4)
        self.assertLess(self.motions(37)[-1].covariance[0], 1e-4)

    def test_6_another_odometry_keeps_its_transform(self):
        self.let_another_publish_the_transform(self.images[self.sent].header.stamp)
        self.send(4)
        self.assert_keeps_a_frame_of_its_own(41)

    def test_7_beside_the_products_odometry_a_second_one_only_tells_its_own(self):
        self.assert_the_second_one_tells_only_its_own(41, 1e-9)


if __name__ == "__main__":
    rospy.init_node("visual_test")
    rostest.rosrun("slam_tests", "visual", VisualTest, sys.argv)
