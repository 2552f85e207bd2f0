# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the picture of what was seen shows."""
import types
import unittest

import numpy as np

from slam_eval.plot import seen


class Views:
    """Counts of two images."""

    stamps = np.array([1, 2])
    counts = {"features": np.array([300, 290]), "expected": np.array([40, 42]),
              "matched": np.array([35, 36]), "rejected": np.array([2, 4])}

    def __len__(self):
        return 2


def updates(**counts):
    """Updates with these counts, zeros for all others."""
    zeros = np.zeros(2, dtype=int)
    return types.SimpleNamespace(stamps=np.array([1, 2]), counts={
        name: np.array(counts.get(name, zeros)) for name in ("used", "gated", "added", "unknown")})


class SeriesOfARun(unittest.TestCase):

    def test_is_of_its_images_where_it_has_some(self):
        run = types.SimpleNamespace(views=Views(), updates=updates(used=[1, 1]))
        stamps, counts = seen.series_of(run)
        self.assertEqual(stamps.tolist(), [1, 2])
        self.assertEqual({label: values.tolist() for label, values in counts.items()},
                         {"features located": [300, 290], "searched for": [40, 42],
                          "matched": [35, 36], "rejected": [2, 4]})

    def test_is_else_of_its_observations(self):
        run = types.SimpleNamespace(views=None, updates=updates(used=[3, 4], gated=[1, 0],
                                                                added=[2, 0], unknown=[0, 5]))
        _, counts = seen.series_of(run)
        self.assertEqual({label: values.tolist() for label, values in counts.items()},
                         {"observed": [6, 9], "new to the map": [2, 0], "used": [3, 4],
                          "gated": [1, 0]})

    def test_is_none_where_nothing_was_seen(self):
        for nothing in (None, updates()):
            self.assertIsNone(seen.series_of(types.SimpleNamespace(views=None, updates=nothing)))


class Averaged(unittest.TestCase):

    def test_keeps_the_sum_and_few_points(self):
        for count in (1, 1000, 1001, 2500):
            values = np.arange(count)
            t, means = seen.averaged(values.astype(float), values)
            self.assertLessEqual(len(means), seen.MOST_POINTS)
            self.assertEqual(t.tolist(), means.tolist())
            width = -(-count // seen.MOST_POINTS)
            sizes = np.minimum(width, count - width * np.arange(len(means)))
            self.assertAlmostEqual(np.sum(means * sizes), np.sum(values))


if __name__ == "__main__":
    unittest.main()
