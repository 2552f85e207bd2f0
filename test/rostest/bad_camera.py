#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad data of a camera lead to a warning that names topic and cause, and the product runs on."""

import sys
import threading
import time
import unittest

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from nav_msgs.msg import Odometry
from player import wait_for
from rosgraph_msgs.msg import Log
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, Image
from tf2_msgs.msg import TFMessage

WIDTH, HEIGHT = 64, 48
HELD = 30  # images that wait for calibration and transform
IMAGE, INFO = "camera/image_raw", "camera/camera_info"


def camera_info():
    info = CameraInfo(width=WIDTH, height=HEIGHT, distortion_model="plumb_bob", D=[0.0] * 5)
    info.K = [50.0, 0.0, 31.5, 0.0, 50.0, 23.5, 0.0, 0.0, 1.0]
    return info


def image(stamp, encoding="mono8", bytes_per_pixel=1, frame="camera"):
    message = Image(width=WIDTH, height=HEIGHT, encoding=encoding, step=WIDTH * bytes_per_pixel)
    message.header.stamp = stamp
    message.header.frame_id = frame
    message.data = bytes([120]) * (HEIGHT * message.step)
    return message


class BadCameraTest(unittest.TestCase):
    """The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.nodelet = rospy.get_param("~nodelet")
        cls.lock = threading.Lock()
        cls.received = {}
        cls.stamp = rospy.Time(1000)
        cls.odom = rospy.Publisher("odom", Odometry, queue_size=1000)
        cls.image = rospy.Publisher(IMAGE, Image, queue_size=1000)
        cls.info = rospy.Publisher(INFO, CameraInfo, queue_size=10)
        cls.transforms = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        edge = TransformStamped(child_frame_id="camera")
        edge.header.frame_id = "base_link"
        edge.transform.rotation.w = 1.0
        cls.transforms.publish(TFMessage([edge]))
        cls.subscribers = [rospy.Subscriber(topic, kind, cls.keep, topic, queue_size=1000)
                           for topic, kind in (("pose", PoseWithCovarianceStamped),
                                               ("/rosout", Log), ("/diagnostics", DiagnosticArray))]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0 for p in
                                             (cls.odom, cls.image, cls.info, cls.transforms)), 30)

    @classmethod
    def keep(cls, message, topic):
        with cls.lock:
            cls.received.setdefault(topic, []).append(message)

    def setUp(self):
        self.assertTrue(self.connected)
        with self.lock:
            self.received.clear()

    def get(self, topic):
        with self.lock:
            return list(self.received.get(topic, []))

    def play(self, count, make_image=image):
        """Odometry and an image, `count` times, 10 a second by their stamps."""
        for _ in range(count):
            for _ in range(2):
                type(self).stamp += rospy.Duration(0.05)
                odometry = Odometry(child_frame_id="base_link")
                odometry.header.frame_id = "odom"
                odometry.header.stamp = self.stamp
                odometry.pose.pose.orientation.w = 1.0
                self.odom.publish(odometry)
            self.image.publish(make_image(self.stamp - rospy.Duration(0.01)))
            time.sleep(0.005)

    def calibrate(self, info):
        self.info.publish(info)
        time.sleep(0.3)

    def assert_poses(self, count):
        self.assertTrue(wait_for(lambda: len(self.get("pose")) >= count),
                        f"{len(self.get('pose'))} poses came")

    def assert_warned(self, text):
        def warned():
            return any(self.nodelet in log.msg and IMAGE in log.msg and text in log.msg
                       for log in self.get("/rosout") if log.level == Log.WARN)
        self.assertTrue(wait_for(warned, 6), [log.msg for log in self.get("/rosout")])

    def values(self):
        """Level, message and values of the nodelet's newest diagnostic."""
        for array in reversed(self.get("/diagnostics")):
            for status in array.status:
                if status.name.startswith(self.nodelet):
                    return {"level": status.level, "message": status.message,
                            **{entry.key: entry.value for entry in status.values}}
        return {}

    def count(self, reason):
        values = self.values()
        return int(values.get(reason, values.get("camera_" + reason, 0)))

    def test_1_images_without_camera_info(self):
        self.play(HELD + 15)
        self.assert_warned("come without the camera's calibration")
        self.assert_poses(10)
        self.assertTrue(wait_for(lambda: self.count("no_calibration") > 0))

    def test_2_camera_info_of_zeros(self):
        self.calibrate(CameraInfo(width=WIDTH, height=HEIGHT))
        self.play(10)
        self.assert_warned("calibration cannot be used")
        self.assert_poses(10)
        self.assertTrue(wait_for(lambda: self.count("bad_calibration") > 0))

    def test_3_camera_info_of_another_resolution(self):
        info = camera_info()
        info.width, info.height = 640, 480
        self.calibrate(info)
        self.play(10)
        self.assert_warned("does not fit the calibration for 640x480")
        self.assert_poses(10)
        self.assertTrue(wait_for(lambda: self.count("image_size") > 0))

    def test_4_unknown_distortion_model(self):
        info = camera_info()
        info.distortion_model = "fish_bowl"
        self.calibrate(info)
        self.play(10)
        self.assert_warned("fish_bowl")
        self.assert_poses(10)

    def test_5_good_images_of_any_encoding_make_no_warning(self):
        self.calibrate(camera_info())
        time.sleep(5.5)  # the diagnostic keeps a warning for five seconds
        with self.lock:
            self.received.clear()
        for encoding, size in (("mono8", 1), ("bgr8", 3), ("rgba8", 4), ("mono16", 2),
                               ("bayer_rggb8", 1)):
            self.play(3, lambda stamp: image(stamp, encoding, size))
        self.assert_poses(15)
        self.assertTrue(wait_for(lambda: self.values().get("message") == "running", 3),
                        self.values())
        self.assertEqual([log.msg for log in self.get("/rosout") if log.level >= Log.WARN], [])

    def test_6_encoding_that_does_not_say_what_it_means(self):
        self.play(5, lambda stamp: image(stamp, "16UC1", 2))
        self.assert_warned("the encoding '16UC1' cannot be used")
        self.assert_poses(5)
        self.assertTrue(wait_for(lambda: self.count("unreadable") > 0))

    def test_7_stamps_that_go_back(self):
        self.play(5)
        self.play(1, lambda stamp: image(stamp - rospy.Duration(0.3)))
        self.play(5)
        self.assert_warned("not newer than the one before")
        self.assert_poses(10)
        self.assertTrue(wait_for(lambda: self.count("late") == 1))

    def test_8_drawn_images_come_while_somebody_looks(self):
        look = rospy.Subscriber("detections/image", Image, self.keep, "detections", queue_size=100)
        self.assertTrue(wait_for(lambda: look.get_num_connections() > 0))
        self.play(5)
        self.assertTrue(wait_for(lambda: len(self.get("detections")) > 0))
        drawn = self.get("detections")[-1]
        look.unregister()
        self.assertEqual((drawn.encoding, drawn.width, drawn.height), ("bgr8", WIDTH, HEIGHT))
        self.assertEqual(drawn.header.frame_id, "camera")

    def test_9_images_of_a_frame_without_transform(self):
        self.play(HELD + 15, lambda stamp: image(stamp, frame="nowhere"))
        self.assert_warned("it is not known where the camera of frame 'nowhere' is mounted")
        self.assert_poses(10)
        self.assertTrue(wait_for(lambda: self.count("no_mount") > 0))
        if self.nodelet == "fiducial_detector":
            values = self.values()
            for name in ("rate [1/s]", "latency p50 [ms]", "latency p99 [ms]"):
                self.assertGreater(float(values[name]), 0, name)

    def test_99_a_camera_that_has_died_is_no_running_detector(self):
        self.play(5)
        self.assertTrue(wait_for(lambda: "stale: nothing has come on" in
                                 self.values().get("message", ""), 15), self.values())
        self.assertEqual(self.values()["level"], DiagnosticStatus.WARN)


if __name__ == "__main__":
    rospy.init_node("bad_camera_test")
    rostest.rosrun("slam_tests", "bad_camera", BadCameraTest, sys.argv)
