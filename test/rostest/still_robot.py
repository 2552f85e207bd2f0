# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot with a laser that stands still, for tests of what a product makes of its scans."""

import math
import struct
import threading
import time
import unittest

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from nav_msgs.msg import Odometry
from player import wait_for
from rosgraph_msgs.msg import Log
import rospy
from sensor_msgs.msg import LaserScan, PointCloud2
from slam_msgs.msg import LandmarkObservationArray
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage


def scan(stamp, frame="laser", beams=11, range_=2.0):
    message = LaserScan(angle_min=-0.05 * (beams - 1), angle_max=0.05 * (beams - 1),
                        angle_increment=0.1, range_min=0.1, range_max=8.0)
    message.header.stamp = stamp
    message.header.frame_id = frame
    message.ranges = [range_] * beams
    return message


def mount(child, x=0.0, roll=0.0):
    edge = TransformStamped(child_frame_id=child)
    edge.header.frame_id = "base_link"
    edge.transform.translation.x = x
    edge.transform.rotation.x = math.sin(roll / 2)
    edge.transform.rotation.w = math.cos(roll / 2)
    return edge


class StillRobot(unittest.TestCase):
    """Odometry and observations of a robot that stands, each scan a little older."""

    @classmethod
    def setUpClass(cls):
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
        self.see(self.stamp)

    def see(self, stamp):
        array = LandmarkObservationArray(sequence=self.sequence)
        array.header.stamp = stamp
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
