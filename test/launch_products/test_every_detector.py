# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products with detectors that see no ids are launched: as many as have each of these detectors and
every feature that goes with one."""

import os
import unittest

from product_launches import ProductLaunches
from slam_launch.covering import covering

# features whose combinations are all tried
TOGETHER = 2 if "SLAM_TEST_ALL" in os.environ else 1


class EveryDetectorTest(ProductLaunches, unittest.TestCase):
    def test_publishes_what_its_features_promise(self):
        valid = self.model.valid()
        with_ids = {features["detector"] for features in valid
                    if features["association"] == "known_ids"}
        nearest = [features for features in valid if features["detector"] not in with_ids
                   and features["association"] == "nearest"]  # others change nothing of the nodes
        tried = covering(nearest, TOGETHER)
        self.assertEqual({features["detector"] for features in tried},
                         {features["detector"] for features in valid} - with_ids)
        self.assert_publish_what_they_promise(tried)


if __name__ == "__main__":
    unittest.main()
