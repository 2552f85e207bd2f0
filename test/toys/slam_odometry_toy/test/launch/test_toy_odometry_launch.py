# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package of its own brings a product: the feature model knows it, slam.launch launches it."""

import sys
import unittest

import rospkg
from slam_launch import launch_checks, ports, products
from slam_launch.feature_model import FeatureModel

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import ReplayOfProduct  # noqa: E402


class ToyOdometryLaunch(ReplayOfProduct, unittest.TestCase):
    product = "ekf_toy_odometry"

    def test_the_feature_model_has_it_for_back_ends_that_take_motion(self):
        model = FeatureModel()
        self.assertIn(self.product, [product.name for product in products.named(model)])
        for backend in ("ekf", "pf"):
            model.require_valid({"backend": backend, "odometry": "toy"})

    def test_leaves_the_drivers_transform_to_the_driver(self):
        product = products.find(self.product, FeatureModel())
        self.assertFalse(ports.of_product(product).owns_odometry_edge)
        self.assertEqual(launch_checks.publishes_edge(product, {"bag": ""}), "false")


if __name__ == "__main__":
    unittest.main()
