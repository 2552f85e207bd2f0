# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Consistency of a map without truth."""
import unittest

import numpy as np

from slam_eval.metrics.loop_consistency import consistency, Errors, map_by_odometry

# 1 and 2 are seen together at once, 3 only at the end of the loop, beside 1.
SIGHTS = [{1: (1.0, 0.0), 2: (2.0, 0.0)}, {}, {}, {1: (1.0, 0.0), 3: (1.0, 1.0)}]


class LoopConsistencyTest(unittest.TestCase):
    def test_a_map_like_the_sights_has_no_error_wherever_it_lies(self):
        c = consistency(SIGHTS, {1: (5.0, 5.0), 2: (5.0, 6.0), 3: (4.0, 5.0)}, 3)
        self.assertEqual((c.near.pairs, c.seam.pairs), (1, 1))
        self.assertAlmostEqual(c.near.rms, 0.0)
        self.assertAlmostEqual(c.seam.rms, 0.0)

    def test_a_loop_left_open_shows_in_the_pairs_across_it_alone(self):
        c = consistency(SIGHTS, {1: (0.0, 0.0), 2: (1.0, 0.0), 3: (0.0, 1.5)}, 3)
        self.assertAlmostEqual(c.near.rms, 0.0)
        self.assertAlmostEqual(c.seam.rms, 0.5)
        self.assertAlmostEqual(c.seam.median, 0.5)

    def test_what_was_never_seen_together_or_is_not_mapped_does_not_count(self):
        c = consistency(SIGHTS, {2: (1.0, 0.0), 3: (0.0, 9.0)}, 3)
        self.assertEqual((c.near, c.seam), (Errors(0), Errors(0)))

    def test_repeated_sights_are_averaged(self):
        sights = [{1: (0.0, 0.0), 2: (1.0, 0.0)}, {1: (0.0, 0.0), 2: (3.0, 0.0)}]
        self.assertAlmostEqual(consistency(sights, {1: (0, 0), 2: (2, 0)}, 5).near.rms, 0.0)

    def test_dead_reckoning_puts_a_landmark_where_it_was_first_seen(self):
        positions = map_by_odometry([{1: (1.0, 0.0)}, {1: (5.0, 5.0), 2: (1.0, 0.0)}],
                                    [(0.0, 0.0, 0.0), (1.0, 2.0, np.pi / 2)])
        np.testing.assert_allclose(positions[1], (1.0, 0.0))
        np.testing.assert_allclose(positions[2], (1.0, 3.0))


if __name__ == "__main__":
    unittest.main()
