#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad data of a laser lead to a warning that names topic and cause, and the product runs on."""

import math
import struct
import sys
import threading
import time
import unittest

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from nav_msgs.msg import Odometry
from player import wait_for
from rosgraph_msgs.msg import Log
import rospy
import rostest
from sensor_msgs.msg import LaserScan, PointCloud2
from slam_msgs.msg import LandmarkObservationArray
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

HELD = 200  # scans that wait for the transform
MIDDLE = 5  # of 11 beams


def scan(stamp, frame="laser", beams=11, range_=2.0):
    message = LaserScan(angle_min=-0.05 * (beams - 1), angle_max=0.05 * (beams - 1),
                        angle_increment=0.1, range_min=0.1, range_max=8.0)
    message.header.stamp = stamp
    message.header.frame_id = frame
    message.ranges = [range_] * beams
    return message


def changed(**fields):
    """Returns what makes a scan with some fields of its own."""
    def make(stamp):
        message = scan(stamp)
        for name, value in fields.items():
            setattr(message, name, value)
        return message
    return make


def mount(child, x=0.0, roll=0.0):
    edge = TransformStamped(child_frame_id=child)
    edge.header.frame_id = "base_link"
    edge.transform.translation.x = x
    edge.transform.rotation.x = math.sin(roll / 2)
    edge.transform.rotation.w = math.cos(roll / 2)
    return edge


class BadScanTest(unittest.TestCase):
    """The robot stands still. The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.nodelet = rospy.get_param("~nodelet")
        cls.lock = threading.Lock()
        cls.received = {}
        cls.stamp = rospy.Time(1000)
        cls.sequence = 0
        cls.odom = rospy.Publisher("odom", Odometry, queue_size=1000)
        cls.seen = rospy.Publisher("observations", LandmarkObservationArray, queue_size=1000)
        cls.scan = rospy.Publisher("scan", LaserScan, queue_size=1000)
        cls.transforms = rospy.Publisher("/tf_static", TFMessage, queue_size=10, latch=True)
        cls.subscribers = [
            rospy.Subscriber(topic, kind, cls.keep, topic, queue_size=1000)
            for topic, kind in (("pose", PoseWithCovarianceStamped), ("/rosout", Log),
                                ("points", PointCloud2), ("/diagnostics", DiagnosticArray))]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0 for p in
                                             (cls.odom, cls.seen, cls.scan, cls.transforms)), 30)

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

    def step(self):
        """Odometry and observations, 50 ms later."""
        type(self).stamp += rospy.Duration(0.05)
        odometry = Odometry(child_frame_id="base_link")
        odometry.header.frame_id = "odom"
        odometry.header.stamp = self.stamp
        odometry.pose.pose.orientation.w = 1.0
        self.odom.publish(odometry)
        array = LandmarkObservationArray(sequence=self.sequence)
        array.header.stamp = self.stamp
        array.header.frame_id = "base_link"
        type(self).sequence += 1
        self.seen.publish(array)

    def play(self, count, make_scan=scan):
        for _ in range(count):
            self.step()
            self.scan.publish(make_scan(self.stamp - rospy.Duration(0.01)))
            time.sleep(0.005)
        self.step()

    def begin_anew(self):
        """An empty point map at the origin."""
        rospy.ServiceProxy("reset", Trigger)()
        time.sleep(0.3)
        self.step()
        self.step()

    def points(self):
        """The newest cloud's points in the plane."""
        clouds = self.get("points")
        if not clouds:
            return []
        cloud = clouds[-1]
        return [struct.unpack_from("ff", cloud.data, i * cloud.point_step)
                for i in range(cloud.width)]

    def assert_point(self, x, y):
        def there():
            return any(math.hypot(px - x, py - y) < 0.05 for px, py in self.points())
        self.assertTrue(wait_for(there, 6), f"({x:.2f}, {y:.2f}) is not among {self.points()}")

    def assert_poses(self, count):
        self.assertTrue(wait_for(lambda: len(self.get("pose")) >= count),
                        f"{len(self.get('pose'))} poses came")

    def assert_warned(self, text):
        def warned():
            return any(self.nodelet in log.msg and "scan" in log.msg and text in log.msg
                       for log in self.get("/rosout") if log.level == Log.WARN)
        self.assertTrue(wait_for(warned, 6), [log.msg for log in self.get("/rosout")])

    def count(self, reason):
        """Of the nodelet's newest diagnostic."""
        for array in reversed(self.get("/diagnostics")):
            for status in array.status:
                if status.name.startswith(self.nodelet):
                    values = {entry.key: entry.value for entry in status.values}
                    return int(values.get("laser_" + reason, 0))
        return 0

    def test_01_scans_without_a_transform_wait(self):
        self.play(HELD + 10)
        self.assert_warned("it is not known where the laser of frame 'laser' is mounted")
        self.assert_poses(HELD)
        self.assertEqual(self.points(), [])
        self.assertTrue(wait_for(lambda: self.count("no_mount") == 10), self.count("no_mount"))

    def test_02_the_transform_comes_after_all(self):
        self.transforms.publish(TFMessage([mount("laser", x=0.5)]))
        self.play(5)
        self.assert_point(2.5, 0.0)

    def test_03_ranges_that_tell_nothing(self):
        self.begin_anew()
        ranges = [2.0] * 11
        ranges[:MIDDLE] = [math.nan, -math.inf, math.inf, 0.0, 99.0]
        self.play(5, changed(ranges=ranges))
        self.assert_point(2.5, 0.0)
        self.assertEqual(len(self.points()), 6, "of the beams that met something")
        self.assertEqual([log.msg for log in self.get("/rosout") if log.level >= Log.WARN], [])

    def test_04_another_number_of_beams(self):
        self.begin_anew()
        self.play(3)
        self.play(3, lambda stamp: scan(stamp, beams=3, range_=4.0))
        self.assert_point(4.5, 0.0)
        self.assert_point(2.5, 0.0)

    def test_05_intensities_of_a_wrong_length(self):
        self.begin_anew()
        self.play(5, changed(intensities=[1.0] * 3))
        self.assert_point(2.5, 0.0)

    def test_06_angle_increment_of_zero(self):
        self.play(5, changed(angle_increment=0.0))
        self.assert_warned("angle_increment is 0")
        self.assertTrue(wait_for(lambda: self.count("bad_scan") > 0))

    def test_07_angle_increment_against_the_angles(self):
        self.play(5, changed(angle_increment=-0.1))
        self.assert_warned("its angles run from -0.5 to 0.5 and its angle_increment of -0.1 the "
                           "other way")

    def test_08_angles_that_do_not_fit_the_ranges(self):
        self.play(5, changed(ranges=[2.0] * 20))
        self.assert_warned("it has 20 ranges, while its angles tell 11")
        self.assert_poses(5)

    def test_09_a_laser_upside_down_sees_the_other_way_round(self):
        self.begin_anew()
        self.transforms.publish(TFMessage([mount("below", roll=math.pi)]))
        ranges = [math.nan] * 10 + [2.0]  # the last beam, at +0.5 rad of the laser
        self.play(5, lambda stamp: changed(ranges=ranges,
                                           header=scan(stamp, "below").header)(stamp))
        self.assert_point(2.0 * math.cos(0.5), -2.0 * math.sin(0.5))

    def test_10_a_laser_on_its_side_is_refused(self):
        self.begin_anew()
        self.transforms.publish(TFMessage([mount("side", roll=math.pi / 2)]))
        self.play(5, lambda stamp: scan(stamp, "side"))
        self.assert_warned("not horizontal")
        self.assert_poses(5)
        self.assertTrue(wait_for(lambda: self.count("bad_mount") > 0))
        self.assertEqual(self.points(), [])

    def test_11_a_clockwise_scan(self):
        self.begin_anew()
        ranges = [math.nan] * 10 + [2.0]  # the last beam, at -0.5 rad
        self.play(5, changed(angle_min=0.5, angle_max=-0.5, angle_increment=-0.1, ranges=ranges))
        self.assert_point(0.5 + 2.0 * math.cos(0.5), -2.0 * math.sin(0.5))

    def test_12_scans_without_odometry_between_them(self):
        self.begin_anew()
        for number in range(5):
            self.scan.publish(scan(self.stamp + rospy.Duration(0.005 * (number + 1))))
        self.play(3)
        self.assert_point(2.5, 0.0)


if __name__ == "__main__":
    rospy.init_node("bad_scan_test")
    rostest.rosrun("slam_tests", "bad_scan", BadScanTest, sys.argv)
