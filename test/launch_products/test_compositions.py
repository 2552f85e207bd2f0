# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products of landmarks, the first of them the thesis's (6.2.1 to 6.2.4): every composition writes the
same files."""

import unittest

from compositions import Compositions

PRODUCTS = ("ekf_wheel", "pf_wheel", "pf_visual", "ekf_wheel_pointmap", "ekf_ceiling", "ekf_laser",
            "ekf_wheel_imu", "ekf_wheel_lines", "graph_wheel")


class CompositionsTest(Compositions, unittest.TestCase):
    def test_write_the_same_files_as_offline(self):
        for product in PRODUCTS:
            self.assert_same_as_offline(product)


if __name__ == "__main__":
    unittest.main()
