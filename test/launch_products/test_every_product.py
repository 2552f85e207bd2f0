# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products whose observations have ids are launched: as many as have every feature. That components
of any three fit each other is known without a launch (test_ports)."""

import os
import unittest

from product_launches import ProductLaunches
from slam_launch.covering import covering

# features whose combinations are all tried: faults of more than three at once are rare
TOGETHER = 3 if "SLAM_TEST_ALL" in os.environ else 1


class EveryProductTest(ProductLaunches, unittest.TestCase):
    def test_publishes_what_its_features_promise(self):
        valid = [features for features in self.model.valid()
                 if features["association"] == "known_ids"]  # others change nothing of the nodes
        tried = covering(valid, TOGETHER)
        self.assertGreaterEqual(len(tried), 8)
        self.assert_publish_what_they_promise(tried)


if __name__ == "__main__":
    unittest.main()
