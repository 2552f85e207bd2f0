# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error figures, held against scipy and against plain implementations with matrices."""
import pathlib
import sys
import unittest

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.stats import multivariate_normal

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.io.trajectory import Trajectory  # noqa: E402
from slam_eval.io.updates import Updates  # noqa: E402
from slam_eval.metrics import evaluation  # noqa: E402
from slam_eval.metrics.drift import segment_drift  # noqa: E402

T_WORLD_MAP = np.array([4.0, -1.0, 2.2])
COUNT = 300


def matrix(pose):
    """Returns the 3 x 3 matrix of a pose."""
    T = Rotation.from_euler("z", pose[2]).as_matrix()
    T[:2, 2] = pose[:2]
    return T


def pose_of(T):
    """Returns the pose of a 3 x 3 matrix."""
    return np.array([T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])])


class IndependentFigures(unittest.TestCase):
    """A path with errors of a centimetre and of half a degree, in a map that lies anywhere."""

    def setUp(self):
        random = np.random.default_rng(3)
        self.stamps = np.arange(COUNT, dtype=np.int64) * 100_000_000
        poses = run_maker.ring(COUNT)
        self.estimate = poses + np.cumsum(random.normal(0.0, [1e-3, 1e-3, 5e-4], poses.shape), 0)
        self.truth = np.array([pose_of(matrix(T_WORLD_MAP) @ matrix(pose)) for pose in poses])
        roots = random.normal(0.0, 0.02, (COUNT, 3, 3)) + 0.05 * np.eye(3)
        self.covariances = roots @ roots.transpose(0, 2, 1)

    def ours(self, poses):
        return Trajectory(self.stamps, np.array(poses))

    def in_map(self):
        """Returns the true poses in the map, whose frame the first pose tells."""
        T_map_world = matrix(self.estimate[0]) @ np.linalg.inv(matrix(self.truth[0]))
        return np.array([pose_of(T_map_world @ matrix(pose)) for pose in self.truth])

    def test_the_aligned_error_is_that_of_scipys_alignment(self):
        planar = [np.column_stack([poses[:, :2] - poses[:, :2].mean(axis=0), np.zeros(COUNT)])
                  for poses in (self.truth, self.estimate)]
        _, root_of_squares = Rotation.align_vectors(*planar)
        found = evaluation.trajectory_error(self.ours(self.estimate), self.ours(self.truth))
        self.assertGreater(found.rmse, 1e-3)
        self.assertAlmostEqual(found.rmse, root_of_squares / np.sqrt(COUNT), places=9)

    def test_the_error_without_alignment_is_that_of_matrices(self):
        distances = np.linalg.norm((self.estimate - self.in_map())[:, :2], axis=1)
        found = evaluation.trajectory_error(self.ours(self.estimate), self.ours(self.truth),
                                            align=False)
        np.testing.assert_allclose(found.errors, distances, atol=1e-9)

    def test_nees_is_what_the_density_of_a_gaussian_says(self):
        updates = Updates(self.stamps, self.covariances, np.zeros(COUNT), np.zeros(COUNT), {})
        found = evaluation.pose_consistency(self.ours(self.estimate), updates,
                                            self.ours(self.truth))
        self.assertEqual(len(found.nees), COUNT)
        for error, covariance, nees in zip(self.estimate - self.in_map(), self.covariances,
                                           found.nees):
            error[2] = (error[2] + np.pi) % (2.0 * np.pi) - np.pi
            density = multivariate_normal(cov=covariance)
            self.assertAlmostEqual(
                nees, 2.0 * (density.logpdf(np.zeros(3)) - density.logpdf(error)), places=6)

    def test_drift_is_that_of_matrices(self):
        length, translations, turns = 1.0, [], []
        steps = np.linalg.norm(np.diff(self.truth[:, :2], axis=0), axis=1)
        for begin in range(COUNT):
            way, end = 0.0, begin
            while way < length and end + 1 < COUNT:
                way += steps[end]
                end += 1
            if way < length:
                break
            true = np.linalg.inv(matrix(self.truth[begin])) @ matrix(self.truth[end])
            ours = np.linalg.inv(matrix(self.estimate[begin])) @ matrix(self.estimate[end])
            error = pose_of(np.linalg.inv(true) @ ours)
            translations.append(np.hypot(error[0], error[1]) / way)
            turns.append(abs(error[2]) / way)
        found = segment_drift(self.ours(self.estimate), self.ours(self.truth), length)
        self.assertEqual(found.pieces, len(turns))
        self.assertAlmostEqual(found.translation, np.mean(translations), places=9)
        self.assertAlmostEqual(found.rotation_rad_per_m, np.mean(turns), places=9)


if __name__ == "__main__":
    unittest.main()
