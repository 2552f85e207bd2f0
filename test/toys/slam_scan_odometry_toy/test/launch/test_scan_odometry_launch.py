# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""An odometry source that takes in scans, in a package of its own, drives the EKF."""

import math
import sys
import unittest

from geometry_msgs.msg import Pose2D
import rosbag
import rospkg
from slam_launch import products
from slam_launch.feature_model import FeatureModel
from slam_msgs.msg import LandmarkObservation, LandmarkObservationArray

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import largest_error, make_drive_bag, ReplayOfProduct  # noqa: E402

FARTHEST = 3.0  # a marker that a camera sees [m]
COVARIANCE = [1e-3, 0, 0, 1e-4]


def seen(stamp, sequence, pose, landmarks):
    """Returns what a camera in the robot's middle sees of the landmarks, by the truth."""
    array = LandmarkObservationArray(sequence=sequence, sensor_pose=Pose2D())
    array.header.stamp = stamp
    array.header.frame_id = "camera"
    turn = 2 * math.atan2(pose.orientation.z, pose.orientation.w)
    for landmark in landmarks:
        x, y = landmark.x - pose.position.x, landmark.y - pose.position.y
        bearing = math.remainder(math.atan2(y, x) - turn, math.tau)
        if math.hypot(x, y) < FARTHEST and abs(bearing) < 1:
            array.observations.append(LandmarkObservation(
                id=landmark.id, range=math.hypot(x, y), bearing=bearing, covariance=COVARIANCE))
    return array


def with_observations(drive, path):
    """Writes a bag that has observations by the truth, and no odometry."""
    with rosbag.Bag(str(drive)) as source, rosbag.Bag(str(path), "w") as target:
        landmarks = next(message.landmarks for _, message, _ in
                         source.read_messages(topics=["/ground_truth/landmarks"]))
        poses = 0
        for topic, message, stamp in source.read_messages():
            if topic not in ("/odom", "/tf"):
                target.write(topic, message, stamp)
            if topic == "/ground_truth/pose":
                if poses % 5 == 3:  # at 10 Hz, between the scans
                    target.write("/observations", seen(message.header.stamp, poses // 5,
                                                       message.pose, landmarks), stamp)
                poses += 1


class ScanOdometryLaunch(ReplayOfProduct, unittest.TestCase):
    product = "ekf_scan_odometry"
    seconds = 10

    @classmethod
    def make_bag(cls, path):
        make_drive_bag(cls.root / "drive.bag", cls.seconds, "odom,scan")
        with_observations(cls.root / "drive.bag", path)

    def test_knows_where_the_robot_is(self):
        self.assertLess(largest_error(self.root / "offline"), 0.05)

    def test_the_feature_model_has_it_for_every_back_end(self):
        model = FeatureModel()
        self.assertIn(self.product, [product.name for product in products.named(model)])
        for backend in ("ekf", "pf"):
            model.require_valid({"backend": backend, "odometry": "scan_toy"})


if __name__ == "__main__":
    unittest.main()
