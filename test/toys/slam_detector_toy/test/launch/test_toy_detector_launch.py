# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package of its own brings a product: the feature model knows it, slam.launch launches it."""

import sys
import unittest

import rospkg
from slam_launch import products
from slam_launch.feature_model import FeatureModel

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import make_drive_bag, ReplayOfProduct  # noqa: E402


class ToyDetectorLaunch(ReplayOfProduct, unittest.TestCase):
    product = "ekf_toy_detector"

    @classmethod
    def make_bag(cls, path):
        make_drive_bag(path, cls.seconds, "odom,scan")

    def test_the_feature_model_has_it_for_back_ends_that_map_landmarks(self):
        model = FeatureModel()
        self.assertIn(self.product, [product.name for product in products.named(model)])
        for backend in ("ekf", "pf", "graph", "seif"):
            model.require_valid({"backend": backend, "odometry": "wheel", "detector": "toy",
                                 "association": "jcbb"})


if __name__ == "__main__":
    unittest.main()
