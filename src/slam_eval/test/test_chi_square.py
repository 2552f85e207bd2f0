# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chi-square distribution against printed tables."""
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.metrics.chi_square import chi_square_quantile, two_sided_bounds  # noqa: E402


class ChiSquare(unittest.TestCase):

    def test_quantiles_equal_the_values_of_printed_tables(self):
        table = {(0.95, 1): 3.841, (0.95, 2): 5.991, (0.95, 3): 7.815, (0.99, 2): 9.210,
                 (0.975, 3): 9.348, (0.025, 3): 0.216, (0.025, 2): 0.0506, (0.95, 10): 18.307,
                 (0.05, 10): 3.940, (0.95, 100): 124.342, (0.025, 100): 74.222}
        for (probability, dof), value in table.items():
            with self.subTest(probability=probability, dof=dof):
                self.assertAlmostEqual(chi_square_quantile(probability, dof), value,
                                       delta=6e-4)

    def test_two_degrees_of_freedom_have_a_closed_form(self):
        for value in (0.01, 1.0, 5.0, 40.0):
            self.assertAlmostEqual(chi_square_quantile(1.0 - math.exp(-0.5 * value), 2), value,
                                   delta=1e-7 * value)

    def test_bounds_of_many_degrees_of_freedom_approach_those_of_a_normal_variable(self):
        for dof in (3000, 100000):
            low, high = two_sided_bounds(dof)
            self.assertAlmostEqual(math.sqrt(2.0 * high) - math.sqrt(2.0 * dof - 1.0), 1.95996,
                                   delta=0.02)
            self.assertAlmostEqual(math.sqrt(2.0 * low) - math.sqrt(2.0 * dof - 1.0), -1.95996,
                                   delta=0.02)

    def test_refuses_a_probability_outside_zero_and_one(self):
        for probability, dof in ((0.0, 3), (1.0, 3), (0.5, 0)):
            with self.assertRaises(ValueError):
                chi_square_quantile(probability, dof)


if __name__ == "__main__":
    unittest.main()
