# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The relative pose error, held against a plain implementation with matrices."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.geometry import se2  # noqa: E402
from slam_eval.io.trajectory import Trajectory  # noqa: E402
from slam_eval.metrics.relative_error import (  # noqa: E402
    metres, relative_error, relative_metrics, seconds)

PERIOD = 100_000_000  # [ns]


def trajectory(poses, stamps=None):
    """Poses every 0.1 s."""
    if stamps is None:
        stamps = np.arange(len(poses), dtype=np.int64) * PERIOD
    return Trajectory(stamps, np.array(poses, dtype=float))


def straight(speed=1.0, turn=0.0, count=101):
    """A drive at a speed [m/s] that turns [rad/s]."""
    poses = [np.zeros(3)]
    for _ in range(count - 1):
        poses.append(se2.compose(poses[-1], [0.1 * speed, 0.0, 0.1 * turn]))
    return trajectory(poses)


def matrix(pose):
    """The 3 x 3 matrix of a pose."""
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, pose[0]], [s, c, pose[1]], [0.0, 0.0, 1.0]])


def by_matrices(estimate, truth, step):
    """Root mean squares of the errors over pieces of so many poses."""
    squares = []
    for i in range(len(estimate) - step):
        P = np.linalg.inv(matrix(estimate[i])) @ matrix(estimate[i + step])
        Q = np.linalg.inv(matrix(truth[i])) @ matrix(truth[i + step])
        E = np.linalg.inv(Q) @ P
        squares.append((E[0, 2] ** 2 + E[1, 2] ** 2, np.arctan2(E[1, 0], E[0, 0]) ** 2))
    return np.sqrt(np.mean(squares, axis=0))


class RelativeError(unittest.TestCase):

    def test_is_that_of_the_definition(self):
        truth = run_maker.ring(count=400)
        noise = np.random.default_rng(5).normal(0.0, [0.02, 0.03, 0.01], truth.shape)
        estimate = truth + noise
        found = relative_error(trajectory(estimate), trajectory(truth), seconds, 1.0)
        translation, rotation = by_matrices(estimate, truth, 10)
        self.assertAlmostEqual(found.translation, translation, places=9)
        self.assertAlmostEqual(found.rotation, rotation, places=9)

    def test_of_a_scale_is_its_part_of_a_metre_at_any_speed(self):
        for speed in (0.5, 1.0, 2.0):
            found = relative_metrics(straight(1.1 * speed), straight(speed))
            self.assertAlmostEqual(found["rpe_trans_1m_m"], 0.1, places=6)
            self.assertAlmostEqual(found["rpe_trans_1s_m"], 0.1 * speed, places=6)
            self.assertAlmostEqual(found["rpe_rot_1s_deg"], 0.0)

    def test_of_a_turn_rate_is_its_angle_in_a_second(self):
        found = relative_metrics(straight(turn=0.02), straight())
        self.assertAlmostEqual(found["rpe_rot_1s_deg"], np.degrees(0.02), places=6)

    def test_needs_no_alignment(self):
        moved = straight()
        moved = Trajectory(moved.stamps, se2.transform_poses([3.0, -1.0, 2.0], moved.poses))
        self.assertAlmostEqual(relative_metrics(moved, straight())["rpe_trans_1s_m"], 0.0)

    def test_one_jump_counts_for_the_pieces_across_it_only(self):
        poses = straight().poses.copy()
        poses[50:, 1] += 1.0
        found = relative_error(trajectory(poses), straight(), seconds, 1.0)
        self.assertAlmostEqual(found.translation, np.sqrt(10 / 91), places=6)

    def test_no_piece_spans_a_gap(self):
        whole = straight()
        kept = np.r_[0:30, 60:101]
        poses = whole.poses[kept].copy()
        poses[30:, 1] += 1.0  # happens in the gap
        cut = trajectory(poses, whole.stamps[kept])
        self.assertAlmostEqual(relative_error(cut, whole, seconds, 1.0).translation, 0.0, places=9)

    def test_is_absent_where_the_robot_stands_or_the_run_is_short(self):
        standing = relative_metrics(straight(0.0), straight(0.0))
        self.assertEqual(set(standing), {"rpe_trans_1s_m", "rpe_rot_1s_deg"})
        self.assertEqual(relative_metrics(straight(count=5), straight(count=5)), {})
        self.assertIsNone(relative_error(straight(), straight(), metres, 20.0))


if __name__ == "__main__":
    unittest.main()
