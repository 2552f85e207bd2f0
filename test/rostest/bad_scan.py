#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad data of a laser lead to a warning that names topic and cause, and the product runs on."""

import math
import sys
import time

from player import wait_for
from rosgraph_msgs.msg import Log
import rospy
import rostest
from still_robot import mount, scan, StillRobot
from tf2_msgs.msg import TFMessage

HELD = 200  # scans that wait for the transform
MIDDLE = 5  # of 11 beams


def changed(**fields):
    """Returns what makes a scan with some fields of its own."""
    def make(stamp):
        message = scan(stamp)
        for name, value in fields.items():
            setattr(message, name, value)
        return message
    return make


class BadScanTest(StillRobot):
    """The robot stands still. The tests go on from one another in the order of their numbers."""

    @classmethod
    def setUpClass(cls):
        cls.nodelet = rospy.get_param("~nodelet")
        super().setUpClass()

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

    def test_13_a_laser_that_tells_no_range(self):
        self.play(30, changed(ranges=[math.nan] * 11))
        self.assert_warned("has told no range since")
        self.assertTrue(wait_for(lambda: self.count("no_range") == 30), self.count("no_range"))

    def test_14_a_scan_of_another_frame_holds_up_none_behind_it(self):
        self.begin_anew()
        self.play(1, lambda stamp: scan(stamp, "nowhere"))
        self.play(5)
        self.assert_point(2.5, 0.0)
        self.assertTrue(wait_for(lambda: self.count("no_mount") == 1), self.count("no_mount"))

    def test_15_the_odometry_stops_and_observations_go_on(self):
        for number in range(80):
            self.see(self.stamp + rospy.Duration(0.05 * (number + 1)))
            time.sleep(0.005)

        def told():
            return any("no update: landmarks since" in status.message
                       and "wait for motion on" in status.message and status.level > 0
                       for array in self.get("/diagnostics") for status in array.status)
        self.assertTrue(wait_for(told, 6))


if __name__ == "__main__":
    rospy.init_node("bad_scan_test")
    rostest.rosrun("slam_tests", "bad_scan", BadScanTest, sys.argv)
