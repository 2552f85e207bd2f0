# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Matching of scans: known motions in rooms that are made, and places that say nothing."""
import math
import unittest

import numpy as np
from slam_doctor.scans import compare
from slam_doctor.scans.match import moved, Reference
from slam_doctor.scans.pairs import Pair


def scan_of(pose, walls, random, beams=360, noise=0.01):
    """What a laser at a pose (x, y, heading) sees of walls (x0, y0, x1, y1): points with noise."""
    angles = np.linspace(-math.pi, math.pi, beams, endpoint=False)
    directions = np.stack([np.cos(angles + pose[2]), np.sin(angles + pose[2])], axis=-1)
    best = np.full(beams, np.inf)
    for x0, y0, x1, y1 in walls:
        along, start = np.array([x1 - x0, y1 - y0]), np.array([x0, y0]) - pose[:2]
        cross = directions[:, 0] * along[1] - directions[:, 1] * along[0]
        with np.errstate(divide="ignore", invalid="ignore"):
            ranges = (start[0] * along[1] - start[1] * along[0]) / cross
            share = (start[0] * directions[:, 1] - start[1] * directions[:, 0]) / cross
        hit = (ranges > 0) & (share >= 0) & (share <= 1)
        best[hit] = np.minimum(best[hit], ranges[hit])
    seen = np.isfinite(best) & (best < 8.0)
    ranges = best[seen] + noise * random.normal(size=seen.sum())
    return ranges[:, None] * np.stack([np.cos(angles[seen]), np.sin(angles[seen])], axis=-1)


ROOM = [(-3, -2, 4, -2), (4, -2, 4, 3), (4, 3, -3, 3), (-3, 3, -3, -2), (1, 1, 1.5, 1.4),
        (1.5, 1.4, 1.1, 1.8), (-2, -1, -1.4, -1)]
CORRIDOR = [(-50, -1, 50, -1), (-50, 1, 50, 1)]


def pair(motion, told, walls, seed):
    """A Pair between which the robot has moved, and odometry tells something."""
    random = np.random.default_rng(seed)
    return Pair(0.0, 1.0, scan_of(np.zeros(3), walls, random), scan_of(np.array(motion), walls,
                                                                       random), np.array(told))


class Matching(unittest.TestCase):
    def test_finds_known_motions(self):
        random = np.random.default_rng(3)
        for seed in range(20):
            motion = np.array([*random.uniform(-0.4, 0.4, 2), random.uniform(-0.3, 0.3)])
            one = pair(motion, motion, ROOM, seed)
            found = Reference(one.first).match(one.second, np.zeros(3))
            np.testing.assert_allclose(found.motion, motion, atol=0.02)
            self.assertGreater(found.share, 0.8)

    def test_moved_points_turn_before_they_shift(self):
        np.testing.assert_allclose(moved((1, 0, math.pi / 2), np.array([[2.0, 0.0]])), [[1, 2]],
                                   atol=1e-12)

    def test_a_corridor_says_nothing_along_it(self):
        one = pair((0.5, 0, 0), (0.5, 0, 0), CORRIDOR, 1)
        found = Reference(one.first).match(one.second, one.odometry)
        self.assertLess(found.observability(0.0), 0.02)
        self.assertGreater(found.observability(math.pi / 2), 0.9)


class Comparing(unittest.TestCase):
    def drives(self, factor, walls=ROOM, sideways=0.0):
        return [pair((0.4 + 0.01 * i, sideways, 0.0), ((0.4 + 0.01 * i) * factor, 0.0, 0.0), walls,
                     i) for i in range(12)]

    def test_the_scale_of_ways(self):
        for factor in (0.6, 0.8, 1.0, 1.3, 1.7):
            found = compare.compare_drives(self.drives(factor))
            self.assertAlmostEqual(found.way.value * factor, 1.0, delta=0.02)
            self.assertLess(found.way.sigma, 0.02)

    def test_ways_backwards(self):
        found = compare.compare_drives(self.drives(-1.0))
        self.assertAlmostEqual(found.way.value, -1.0, delta=0.03)

    def test_the_heading_of_the_mount(self):
        found = compare.compare_drives(self.drives(1.0, sideways=0.08))
        self.assertAlmostEqual(found.heading.value, math.atan2(0.08, 0.455), delta=0.02)

    def test_corridors_say_nothing_about_ways(self):
        self.assertIsNone(compare.compare_drives(self.drives(1.3, CORRIDOR)))

    def turns(self, factor):
        return [pair((0.02, 0.0, 0.2 + 0.01 * i), (0.02, 0.0, (0.2 + 0.01 * i) * factor), ROOM, i)
                for i in range(12)]

    def test_the_scale_of_turns(self):
        for factor in (0.75, 1.0, 1.3):
            found = compare.compare_turns(self.turns(factor))
            self.assertAlmostEqual(found.turn.value * factor, 1.0, delta=0.03)
            self.assertEqual(found.opposite, 0)

    def test_turns_the_other_way(self):
        found = compare.compare_turns(self.turns(-1.0))
        self.assertEqual(found.same, 0)
        self.assertAlmostEqual(found.turn.value, -1.0, delta=0.03)

    def test_round_rooms_say_nothing_about_turns(self):
        circle = [(3 * math.cos(a), 3 * math.sin(a), 3 * math.cos(a + 0.05), 3 * math.sin(a + 0.05))
                  for a in np.arange(0, 2 * math.pi, 0.05)]
        pairs = [pair((0, 0, 0.3), (0, 0, 0.3), circle, i) for i in range(8)]
        self.assertIsNone(compare.compare_turns(pairs))

    def test_too_few_pairs_say_nothing(self):
        self.assertIsNone(compare.compare_turns(self.turns(1.0)[:4]))
        self.assertIsNone(compare.compare_drives([]))

    def test_a_robot_that_stands(self):
        still = compare.motion_of_stand(pair((0, 0, 0), (0, 0, 0), ROOM, 1))
        self.assertIsNone(still)
        moving = compare.motion_of_stand(pair((0.5, 0.1, 0.2), (0, 0, 0), ROOM, 2))
        np.testing.assert_allclose(moving, (0.5, 0.1, 0.2), atol=0.03)


if __name__ == "__main__":
    unittest.main()
