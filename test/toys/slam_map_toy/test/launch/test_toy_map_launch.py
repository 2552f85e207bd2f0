# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A package of its own brings a product: the feature model knows it, slam.launch launches it."""

import sys
import unittest

import rospkg
from slam_launch import products
from slam_launch.feature_model import FeatureModel

sys.path.insert(0, rospkg.RosPack().get_path("slam_tests") + "/launch")
from launching import ReplayOfProduct, run_launch  # noqa: E402


class ToyMapLaunch(ReplayOfProduct, unittest.TestCase):
    product = "ekf_toy_map"

    def test_its_file_is_that_of_the_offline_run(self):
        run = self.root / "with_file"
        run_launch(f"product:={self.product}", f"bag:={self.root}/short.bag", "rate:=0",
                   f"output_dir:={run}")
        self.assertEqual((run / "toy_map.csv").read_bytes(),
                         (self.root / "offline" / "toy_map.csv").read_bytes())

    def test_the_feature_model_has_it_for_every_back_end(self):
        model = FeatureModel()
        self.assertIn(self.product, [product.name for product in products.named(model)])
        for backend in ("ekf", "pf", "graph", "seif"):
            model.require_valid({"backend": backend, "odometry": "wheel", "map_toy": "true"})


if __name__ == "__main__":
    unittest.main()
