# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products that look through cameras without markers, and those with two kinds of markers and two
cameras: every composition writes the same files."""

import unittest

from compositions import Compositions
import yaml

PRODUCTS = ("rat_visual", "graph_mono")
TWO_OF_EACH = ("second_detector=aruco", "second_camera=true")


class CameraCompositionsTest(Compositions, unittest.TestCase):
    def test_write_the_same_files_as_offline(self):
        for product in PRODUCTS:
            self.assert_same_as_offline(product)


class TwoCamerasTest(Compositions, unittest.TestCase):
    WORLD, ROBOT = "foyer", "scout"

    def test_write_the_same_files_as_offline(self):
        for product in ("ekf_wheel", "pf_wheel", "graph_wheel"):
            run = self.assert_same_as_offline(product, TWO_OF_EACH)
            ids = [landmark["id"] for landmark in yaml.safe_load(run["landmarks.yaml"])["landmarks"]]
            self.assertTrue(any(number < 587 for number in ids), ids)
            self.assertTrue(any(10000 <= number < 10050 for number in ids), ids)


if __name__ == "__main__":
    unittest.main()
