# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rigid motions of the plane."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.geometry import se2  # noqa: E402


class Se2(unittest.TestCase):

    def test_wrapped_angles_lie_in_minus_pi_exclusive_to_pi_inclusive(self):
        self.assertEqual(se2.wrap_angle(np.pi), np.pi)
        self.assertEqual(se2.wrap_angle(-np.pi), np.pi)
        self.assertAlmostEqual(float(se2.wrap_angle(7.0)), 7.0 - 2.0 * np.pi)

    def test_inverse_undoes_a_pose(self):
        pose = np.array([1.5, -0.3, 2.9])
        np.testing.assert_allclose(se2.compose(pose, se2.inverse(pose)), 0.0, atol=1e-12)
        np.testing.assert_allclose(se2.compose(se2.inverse(pose), pose), 0.0, atol=1e-12)

    def test_an_end_is_seen_from_its_start(self):
        starts = np.array([[1.0, 2.0, 0.5 * np.pi], [0.0, 0.0, 3.0]])
        ends = np.array([[1.0, 5.0, -0.5 * np.pi], [0.0, 0.0, -3.0]])
        seen = [se2.compose(se2.inverse(start), end) for start, end in zip(starts, ends)]
        np.testing.assert_allclose(se2.relative(starts, ends), seen, atol=1e-12)
        np.testing.assert_allclose(se2.relative(starts, ends)[0], [3.0, 0.0, np.pi], atol=1e-12)

    def test_the_same_poses_give_the_same_bits_wherever_they_lie_in_memory(self):
        random, kept = np.random.default_rng(3), []
        for count in [n for n in range(30, 400) for _ in range(6)]:
            starts = random.uniform(-3.0, 3.0, (count, 3))
            ends = starts[::-1]
            kept = [*kept[-8::2], starts]  # and gaps between them, where results may come to lie
            self.assertEqual(se2.relative(starts, ends).tobytes(),
                             se2.relative(np.asfortranarray(starts), ends).tobytes(), count)

    def test_alignment_finds_the_motion_between_two_copies(self):
        points = np.random.default_rng(4).normal(size=(30, 2))
        for T in ([0.5, -2.0, 3.0], [0.0, 0.0, -1.2], [10.0, 4.0, 0.0]):
            found = se2.align_rigid(points, se2.transform_points(T, points))
            np.testing.assert_allclose(found, T, atol=1e-12)

    def test_alignment_does_not_scale_or_mirror(self):
        points = np.random.default_rng(5).normal(size=(30, 2))
        found = se2.align_rigid(points, 2.0 * points)
        np.testing.assert_allclose(found[2], 0.0, atol=1e-12)
        mirrored = points * [1.0, -1.0]
        moved = se2.transform_points(se2.align_rigid(points, mirrored), points)
        self.assertGreater(np.max(np.abs(moved - mirrored)), 0.5)

    def test_similarity_finds_the_scale_between_two_copies(self):
        points = np.random.default_rng(5).uniform(-3.0, 3.0, (30, 2))
        for scale in (0.5, 1.0, 1.07):
            copy = scale * se2.transform_points(np.array([4.0, -1.0, 2.2]), points)
            self.assertAlmostEqual(se2.similarity_scale(points, copy), scale)

    def test_similarity_is_that_of_a_general_optimiser(self):
        random = np.random.default_rng(6)
        points = random.uniform(-3.0, 3.0, (40, 2))
        moved = 1.1 * se2.transform_points(np.array([4.0, -1.0, 2.2]), points)
        noisy = moved + random.normal(0.0, 0.3, (40, 2))
        # linear least squares in a = s cos, b = s sin, and the translation
        x, y, one, zero = points[:, 0], points[:, 1], np.ones(40), np.zeros(40)
        rows = np.vstack([np.column_stack([x, -y, one, zero]), np.column_stack([y, x, zero, one])])
        a, b = np.linalg.lstsq(rows, noisy.T.ravel(), rcond=None)[0][:2]
        self.assertAlmostEqual(se2.similarity_scale(points, noisy), np.hypot(a, b))

    def test_points_that_coincide_have_no_scale(self):
        self.assertIsNone(se2.similarity_scale(np.zeros((3, 2)), np.ones((3, 2))))

    def test_alignment_of_coinciding_points_is_a_translation(self):
        found = se2.align_rigid(np.zeros((3, 2)), np.ones((3, 2)))
        np.testing.assert_allclose(found, [1.0, 1.0, 0.0])


if __name__ == "__main__":
    unittest.main()
