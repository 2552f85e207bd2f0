# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drift over pieces of the way, and what the benchmark of visual odometry makes of it."""
import json
import math
import unittest

import numpy as np

from slam_eval.bench import vo
from slam_eval.bench.harness.error import BenchError
from slam_eval.geometry import se2
from slam_eval.io.trajectory import Trajectory
from slam_eval.metrics.drift import segment_drift


def line(scale=1.0, turn_per_m=0.0):
    """A straight way of 10 m, measured `scale` times too long and turning by `turn_per_m`."""
    poses, pose = [np.zeros(3)], np.zeros(3)
    for _ in range(100):
        pose = se2.compose(pose, [0.1 * scale, 0.0, 0.1 * turn_per_m])
        poses.append(pose)
    return Trajectory(np.arange(101, dtype=np.int64) * 100_000_000, np.array(poses))


class SegmentDrift(unittest.TestCase):

    def test_a_scale_and_a_turn_are_found(self):
        drift = segment_drift(line(1.03), line())
        self.assertAlmostEqual(drift.translation, 0.03, places=6)
        self.assertAlmostEqual(drift.rotation_rad_per_m, 0.0)
        turning = segment_drift(line(turn_per_m=0.01), line())
        self.assertAlmostEqual(turning.rotation_rad_per_m, 0.01, places=6)
        self.assertAlmostEqual(turning.translation, 0.01, delta=0.001)

    def test_where_the_odometry_starts_does_not_matter(self):
        moved = line()
        moved = Trajectory(moved.stamps, se2.transform_poses([3.0, -1.0, 2.0], moved.poses))
        self.assertAlmostEqual(segment_drift(moved, line()).translation, 0.0)

    def test_a_way_that_is_too_short_has_no_drift(self):
        self.assertIsNone(segment_drift(line(), line(), length=20.0))


class Benchmark(unittest.TestCase):

    RESULT = {"visual": [{"features": "orb", "translation": 0.002, "rotation_rad_per_m": 0.001,
                          "nees_1": 1.0, "nees_100": 0.5}],
              "wheels": {"translation": 0.05, "rotation_rad_per_m": 0.02}}

    def test_rows_are_in_percent_and_degrees(self):
        row, = vo.drive_rows({7: vo.read_result(json.dumps(self.RESULT))})
        self.assertEqual(row[0], "7")
        for value, expected in zip(row[1:], (0.2, math.degrees(0.001), 5.0, math.degrees(0.02), 1.0,
                                             0.5)):
            self.assertAlmostEqual(value, expected)

    def test_other_output_is_an_error(self):
        for text in ("", "{}", "[1]", '{"visual": [{}], "wheels": {}}'):
            with self.subTest(text), self.assertRaises(BenchError):
                vo.read_result(text)


if __name__ == "__main__":
    unittest.main()
