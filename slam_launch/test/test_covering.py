# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Few products that stand for many."""

from itertools import combinations, product
import unittest

from slam_launch.covering import covering


class Covering(unittest.TestCase):
    PRODUCTS = [dict(zip("abcd", values)) for values in product(range(3), repeat=4)
                if values[0] != values[1]]  # a constraint

    @staticmethod
    def combined(products, together):
        return {some for features in products for some in combinations(features.items(), together)}

    def test_has_all_combinations_and_few_products(self):
        for together, most in ((1, 4), (2, 12), (3, 40)):
            chosen = covering(self.PRODUCTS, together)
            self.assertEqual(self.combined(chosen, together),
                             self.combined(self.PRODUCTS, together))
            self.assertLessEqual(len(chosen), most)

    def test_is_the_same_each_time_and_of_the_products_there_are(self):
        chosen = covering(self.PRODUCTS, 2)
        self.assertEqual(chosen, covering(self.PRODUCTS, 2))
        self.assertTrue(all(features in self.PRODUCTS for features in chosen))

    def test_of_no_products_there_are_none(self):
        self.assertEqual(covering([], 2), [])


if __name__ == "__main__":
    unittest.main()
