# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products with a grid, the first of them the thesis's (6.2.5), with one laser and with two: every
composition writes the same files."""

import unittest

from compositions import Compositions

PRODUCTS = ("pf_wheel_grid", "scan_grid", "graph_wheel_grid")
TWO_LASERS = {"scan_grid_wheel": ("pointmap=true",), "pf_wheel_grid": (), "graph_wheel_grid": ()}


class GridCompositionsTest(Compositions, unittest.TestCase):
    def test_write_the_same_files_as_offline(self):
        for product in PRODUCTS:
            self.assert_same_as_offline(product)


class TwoLasersTest(Compositions, unittest.TestCase):
    ROBOT = "twin"

    def test_write_the_same_files_as_offline(self):
        for product, features in TWO_LASERS.items():
            self.assert_same_as_offline(product, ("rear_laser=true", *features))


if __name__ == "__main__":
    unittest.main()
