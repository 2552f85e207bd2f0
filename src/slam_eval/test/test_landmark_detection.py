# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Precision and recall of landmarks against a search of all pairings, and with known answers."""
import unittest

import numpy as np
import run_maker  # noqa: F401, before slam_eval: it finds the source tree
from slam_eval.geometry import se2
from slam_eval.io.landmarks import LandmarkMap
from slam_eval.metrics.landmark_detection import count_pairs, landmark_detection

T = np.array([4.0, -1.0, 2.2])


def landmarks(positions, lines=0):
    positions = np.array(positions, dtype=float).reshape(-1, 2)
    return LandmarkMap(list(range(len(positions))), positions, np.zeros((len(positions), 2, 2)),
                       lines=np.zeros((lines, 2, 2)))


def most_pairs(estimate, truth, radius):
    """As many pairs as there can be, by augmenting paths (Kuhn): an algorithm of another kind."""
    partner = {}

    def finds(i, seen):
        for j, point in enumerate(truth):
            if np.hypot(*(estimate[i] - point)) <= radius and j not in seen:
                seen.add(j)
                if j not in partner or finds(partner[j], seen):
                    partner[j] = i
                    return True
        return False

    return sum(finds(i, set()) for i in range(len(estimate)))


class Pairs(unittest.TestCase):
    def test_are_as_many_as_can_be(self):
        random = np.random.default_rng(3)
        for _ in range(200):
            estimate = random.uniform(0.0, 2.0, (random.integers(0, 9), 2))
            truth = random.uniform(0.0, 2.0, (random.integers(0, 9), 2))
            self.assertEqual(count_pairs(estimate, truth, 0.5), most_pairs(estimate, truth, 0.5))

    def test_hold_each_landmark_once(self):
        self.assertEqual(count_pairs(np.zeros((3, 2)), np.zeros((1, 2)), 0.5), 1)


class Detection(unittest.TestCase):
    def test_knows_doubles_false_and_missing_landmarks(self):
        true = np.array([[0.0, 0.0], [3.0, 0.0], [0.0, 3.0], [5.0, 5.0]])
        seen = np.array([[0.1, 0.0], [3.0, 0.2], [3.1, 0.0], [9.0, 9.0], [0.0, 2.8]])
        found = landmark_detection(landmarks(seen), landmarks(se2.transform_points(T, true)), T)
        self.assertEqual(found.metrics, {"landmark_precision_percent": 60.0,
                                         "landmark_recall_percent": 75.0})

    def test_of_an_empty_map_has_no_precision(self):
        found = landmark_detection(landmarks([]), landmarks([[1.0, 2.0]]), T)
        self.assertEqual(found.metrics, {"landmark_recall_percent": 0.0})

    def test_is_not_told_of_lines(self):
        self.assertIsNone(landmark_detection(landmarks([], lines=2), landmarks([[1.0, 2.0]]), T))


if __name__ == "__main__":
    unittest.main()
