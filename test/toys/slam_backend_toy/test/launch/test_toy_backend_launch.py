# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package of its own brings a product: the feature model knows it, slam.launch launches it."""

import sys
import unittest

import rospkg
from slam_launch import products
from slam_launch.feature_model import FeatureModel

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import ReplayOfProduct  # noqa: E402


class ToyBackendLaunch(ReplayOfProduct, unittest.TestCase):
    product = "toy_wheel"

    def test_the_feature_model_has_it(self):
        model = FeatureModel()
        self.assertIn("toy_wheel", [product.name for product in products.named(model)])
        features = model.require_valid({"backend": "toy", "odometry": "visual"})
        self.assertEqual(products.without_file(features, model).content["libraries"],
                         ["libslam_toy_backend.so"])
        self.assertEqual(model.needed_by("toy", {**features, "backend": "ekf"}), "backend=toy")


if __name__ == "__main__":
    unittest.main()
