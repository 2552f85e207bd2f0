# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sign tests and Holm's correction against scipy and by hand."""
import math
import unittest

import run_maker  # noqa: F401, before slam_eval: it finds the source tree
from scipy.stats import binomtest
from slam_eval.metrics.paired_test import compare_all, exact_p, holm, quartiles


class SignTest(unittest.TestCase):
    def test_is_the_exact_binomial_one(self):
        for smaller in range(9):
            for larger in range(9):
                count = smaller + larger
                expected = binomtest(smaller, count).pvalue if count else 1.0
                self.assertAlmostEqual(exact_p(smaller, larger), expected, places=12)


class Holm(unittest.TestCase):
    def test_is_as_by_hand(self):
        # 4 * 0.005, 3 * 0.01, 2 * 0.03, and 0.04, which may not fall below the one before
        for given, expected in zip(holm([0.01, 0.04, 0.03, 0.005]), [0.03, 0.06, 0.06, 0.02]):
            self.assertAlmostEqual(given, expected)
        self.assertEqual(holm([0.9, 0.8]), [1.0, 1.0])
        self.assertEqual(holm([]), [])


class Comparisons(unittest.TestCase):
    def test_count_pairs_that_both_have(self):
        values = {"a": {("x", 1): 1.0, ("x", 2): 2.0, ("y", 1): 3.0},
                  "b": {("x", 1): 2.0, ("x", 2): 2.0, ("y", 2): 9.0}}
        found, = compare_all(values)
        self.assertEqual((found.smaller, found.larger, found.same), (1, 0, 1))
        self.assertEqual((found.ratio, found.p, found.p_holm), (0.75, 1.0, 1.0))

    def test_count_a_drive_once_that_seeds_do_not_change(self):
        values = {"a": {("x", seed): 1.0 for seed in range(8)},
                  "b": {("x", seed): 2.0 for seed in range(8)}}
        found, = compare_all(values, {("x", seed): "of x" for seed in range(8)})
        self.assertEqual((found.smaller, found.p), (1, 1.0))

    def test_count_drives_apart_whose_values_are_equal(self):
        values = {"a": {("x", seed): 1.0 for seed in range(8)},
                  "b": {("x", seed): 2.0 for seed in range(8)}}
        for drives in ({("x", seed): f"of {seed}" for seed in range(8)}, None):
            found, = compare_all(values, drives)
            self.assertEqual((found.smaller, found.p), (8, 2.0 / 2 ** 8))

    def test_count_a_drive_twice_that_seeds_change(self):
        values = {"a": {("x", 1): 1.0, ("x", 2): 3.0}, "b": {("x", 1): 2.0, ("x", 2): 2.0}}
        found, = compare_all(values, {("x", seed): "of x" for seed in (1, 2)})
        self.assertEqual((found.smaller, found.larger), (1, 1))

    def test_of_systems_without_a_common_drive_there_are_none(self):
        self.assertEqual(compare_all({"a": {("x", 1): 1.0}, "b": {("y", 1): 1.0}}), [])

    def test_are_corrected_for_their_number(self):
        values = {name: {("x", seed): base + 0.01 * seed for seed in range(10)}
                  for name, base in (("a", 1.0), ("b", 2.0), ("c", 3.0))}
        for found in compare_all(values):
            self.assertAlmostEqual(found.p, 2.0 / 2 ** 10)
            self.assertAlmostEqual(found.p_holm, 3 * found.p)

    def test_have_no_ratio_to_nothing(self):
        found, = compare_all({"a": {("x", 1): 1.0}, "b": {("x", 1): 0.0}})
        self.assertTrue(math.isnan(found.ratio))


class Quartiles(unittest.TestCase):
    def test_lie_between_the_values(self):
        self.assertEqual(quartiles([4.0, 1.0, 2.0, 3.0]), (2.5, 1.75, 3.25))
        self.assertEqual(quartiles([7.0]), (7.0, 7.0, 7.0))


if __name__ == "__main__":
    unittest.main()
