# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package of its own brings a kind of data: from a bag, and live in both compositions."""

import math
import signal
import subprocess
import sys
import unittest

import rosbag
import rospkg
from slam_beacon_toy.msg import BeaconRanges
from slam_launch import products
from slam_launch.feature_model import FeatureModel

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import (largest_error, make_drive_bag, ReplayOfProduct, run_launch,  # noqa: E402
                       run_offline, start_launch)

SIGMA = 0.05  # of the ranges, which in truth have no error [m]
EVERY = 5     # poses of the truth, which come at 50 Hz


def beacons():
    """Returns (id, x, y) of the product's beacons."""
    values = products.find("beacon_wheel", FeatureModel()).content["beacon_toy"]["beacons"]
    return list(zip(values[::3], values[1::3], values[2::3]))


def heard(stamp, sequence, pose, start):
    """Returns what a robot hears at a pose, of beacons whose place is known from its start."""
    message = BeaconRanges(sequence=sequence, sigma=SIGMA)
    message.header.stamp = stamp
    turn = 2 * math.atan2(start.orientation.z, start.orientation.w)
    for number, x, y in beacons():
        beacon_x = start.position.x + x * math.cos(turn) - y * math.sin(turn)
        beacon_y = start.position.y + x * math.sin(turn) + y * math.cos(turn)
        message.ids.append(number)
        message.ranges.append(math.hypot(beacon_x - pose.position.x, beacon_y - pose.position.y))
    return message


def with_beacons(drive, path, damaged=()):
    """Writes a bag that has ranges by the truth as well; some messages cannot be used."""
    with rosbag.Bag(str(drive)) as source, rosbag.Bag(str(path), "w") as target:
        start, poses = None, 0
        for topic, message, stamp in source.read_messages():
            target.write(topic, message, stamp)
            if topic != "/ground_truth/pose":
                continue
            start = start or message.pose
            if poses % EVERY == 0:
                ranges = heard(message.header.stamp, poses // EVERY, message.pose, start)
                if ranges.sequence in damaged:
                    ranges.ranges[0] = math.nan
                target.write("/beacons", ranges, stamp)
            poses += 1


class BeaconLaunch(ReplayOfProduct, unittest.TestCase):
    product = "beacon_wheel"
    seconds = 15
    lacks_persist = "beacons"
    files = ("trajectory.tum", "trajectory_final.tum", "updates.csv")  # it makes no map

    @classmethod
    def make_bag(cls, path):
        make_drive_bag(cls.root / "drive.bag", cls.seconds, "odom")
        with_beacons(cls.root / "drive.bag", path)

    def test_knows_where_the_robot_is(self):
        self.assertLess(largest_error(self.root / "offline"), 0.05)
        lines = (self.root / "offline" / "trajectory.tum").read_text(encoding="ascii").splitlines()
        self.assertGreater(len(lines), 9 * self.seconds)

    def test_leaves_out_a_message_that_cannot_be_used_and_says_why(self):
        with_beacons(self.root / "drive.bag", self.root / "damaged.bag", damaged=(7, 20))
        output = run_offline(self.root / "damaged.bag", self.root / "damaged", product=self.product)
        self.assertIn("has a range that is not a number above 0", output)
        self.assertIn("invalid_beacons 2", output)
        self.assertLess(largest_error(self.root / "damaged"), 0.05)

    def test_says_what_a_bag_without_beacons_lacks(self):
        output, _ = run_launch(f"product:={self.product}", f"bag:={self.root}/drive.bag",
                               "rate:=0", f"output_dir:={self.root}/nothing")
        self.assertIn("lacks ranges to beacons: 'beacons' (slam_beacon_toy/BeaconRanges)", output)

    def test_says_that_there_is_no_map_to_save(self):
        launch, environment = start_launch(f"product:={self.product}", "robot:=sim_segway",
                                           "unsafe_paths:=true")
        try:
            subprocess.run(["timeout", "60", "bash", "-c",
                            "until rosservice info save_map; do sleep 0.5; done"],
                           env=environment, check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
            answer = subprocess.run(["rosservice", "call", "save_map", str(self.root / "map.yaml")],
                                    env=environment, text=True, stdout=subprocess.PIPE,
                                    check=False).stdout
            launch.send_signal(signal.SIGINT)
            launch.communicate(timeout=40)
        finally:
            launch.kill()
        self.assertIn("success: False", answer)
        self.assertIn("keeps no map that could be saved", answer)
        self.assertFalse((self.root / "map.yaml").exists())

    def test_the_feature_model_brings_both_libraries(self):
        model = FeatureModel()
        features = model.require_valid({"backend": "beacon_toy", "odometry": "wheel"})
        self.assertEqual(products.without_file(features, model).content["libraries"],
                         ["libslam_beacon_toy.so", "libslam_beacon_toy_binding.so"])


if __name__ == "__main__":
    unittest.main()
