# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A product without odometry: scans alone are its time, from a bag and in both compositions."""

import sys
import unittest

import rosbag
import rospkg
from slam_launch import products
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import largest_error, make_drive_bag, record_launch, ReplayOfProduct  # noqa: E402


class ScanBackendLaunch(ReplayOfProduct, unittest.TestCase):
    product = "scan_alone"
    seconds = 10
    files = ("trajectory.tum", "trajectory_final.tum", "updates.csv")  # it makes no map

    @classmethod
    def make_bag(cls, path):
        make_drive_bag(path, cls.seconds, "odom,scan")  # truth comes at odometry's stamps

    def test_knows_where_the_robot_is(self):
        self.assertLess(largest_error(self.root / "offline"), 0.05)

    def test_tf_leads_from_the_map_to_the_base(self):
        record = self.root / "tf.bag"
        output = record_launch(self.product, self.root / "short.bag", record, ["/tf"])
        self.assertTrue(record.exists(), output)
        with rosbag.Bag(str(record)) as bag:
            edges = {(edge.header.frame_id, edge.child_frame_id): edge.transform
                     for _, message, _ in bag.read_messages() for edge in message.transforms}
        self.assertIn(("map", "odom"), edges)
        base = edges["odom", "base_link"]
        self.assertEqual((base.translation.x, base.translation.y, base.rotation.w), (0, 0, 1))

    def test_the_feature_model_refuses_odometry_with_its_sentence(self):
        model = FeatureModel()
        self.assertIn(self.product, [product.name for product in products.named(model)])
        with self.assertRaisesRegex(ProductError, "takes in no motion, so that it goes with "
                                                  "odometry=none. The nearest valid"):
            model.require_valid({"backend": "scan_toy", "odometry": "wheel"})


if __name__ == "__main__":
    unittest.main()
