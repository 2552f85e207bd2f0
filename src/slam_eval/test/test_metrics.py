# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error figures with known answers."""
import dataclasses
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.geometry import se2  # noqa: E402
from slam_eval.io.landmarks import LandmarkMap  # noqa: E402
from slam_eval.io.run_folder import RunFolder  # noqa: E402
from slam_eval.io.trajectory import Trajectory  # noqa: E402
from slam_eval.io.updates import Updates  # noqa: E402
from slam_eval.metrics import evaluation  # noqa: E402
from slam_eval.report.metric_table import KEYS, merge  # noqa: E402

T = np.array([4.0, -1.0, 2.2])


def trajectory(poses, step=0.1):
    """Poses with a stamp each step seconds."""
    return Trajectory((np.arange(len(poses)) * round(step * 1e9)).astype(np.int64),
                      np.array(poses, dtype=float))


def landmark_map(ids, positions):
    """Landmarks without covariance."""
    return LandmarkMap(list(ids), np.array(positions, dtype=float), np.zeros((len(ids), 2, 2)))


def updates(poses, covariances, nis=0.0, dof=0):
    """Updates at the stamps of the poses."""
    count = len(poses)
    return Updates(poses.stamps, covariances, np.full(count, nis), np.full(count, dof), {})


class TrajectoryError(unittest.TestCase):

    def setUp(self):
        self.poses = run_maker.ring(400)
        self.estimate = trajectory(self.poses)

    def test_a_rotated_and_translated_copy_has_no_error(self):
        result = evaluation.trajectory_error(
            self.estimate, trajectory(se2.transform_poses(T, self.poses)))
        self.assertLess(result.max, 1e-9)
        np.testing.assert_allclose(result.T_truth_map, T, atol=1e-9)

    def test_without_alignment_an_error_at_the_start_is_seen_along_the_whole_way(self):
        line = np.column_stack([np.arange(101.0), np.zeros((101, 2))])
        turned = line.copy()
        turned[0, 2] = 0.1  # the estimate of the heading is wrong at the first pose alone
        turned, truth = trajectory(turned), trajectory(se2.transform_poses(T, line))
        self.assertLess(evaluation.trajectory_error(turned, truth).max, 1e-9)
        result = evaluation.trajectory_error(turned, truth, align=False)
        self.assertAlmostEqual(result.errors[0], 0.0)
        self.assertAlmostEqual(result.max, 100.0 * 2.0 * np.sin(0.05))

    def test_a_robot_that_is_elsewhere_in_its_loaded_map_has_that_error_along_the_whole_way(self):
        off = se2.transform_poses(np.array([10.0, 0.0, 0.0]), self.poses)
        world = trajectory(se2.transform_poses(T, self.poses))
        first = evaluation.trajectory_error(trajectory(off), world, align=False)
        self.assertLess(first.max, 1e-9)  # judged from its first pose on
        world = dataclasses.replace(world, T_truth_map=T)
        result = evaluation.trajectory_error(trajectory(off), world, align=False)
        np.testing.assert_allclose(result.errors, 10.0)
        P = np.tile(np.eye(3), (len(off), 1, 1))
        nees = evaluation.pose_consistency(trajectory(off), updates(trajectory(off), P), world).nees
        np.testing.assert_allclose(nees, 100.0)

    def test_a_scaled_copy_keeps_its_error(self):
        line = np.column_stack([np.linspace(-1.0, 1.0, 201), np.zeros((201, 2))])
        result = evaluation.trajectory_error(trajectory(line), trajectory(line * [1.1, 1.0, 1.0]))
        self.assertAlmostEqual(result.max, 0.1, places=9)
        self.assertAlmostEqual(result.rmse, np.sqrt(np.mean((0.1 * line[:, 0]) ** 2)), places=9)

    def test_the_scale_of_a_path_is_told_from_its_place(self):
        world = se2.transform_poses(T, self.poses)
        self.assertAlmostEqual(evaluation.scale_error(self.estimate, trajectory(world)), 0.0)
        large = trajectory(self.poses * [1.03, 1.03, 1.0])
        self.assertAlmostEqual(evaluation.scale_error(large, trajectory(world)), 0.03)
        self.assertIsNone(evaluation.scale_error(trajectory(0.0 * self.poses), trajectory(world)))

    def test_a_zigzag_of_known_size_is_the_error(self):
        count = 400
        line = np.column_stack([np.linspace(0.0, 100.0, count), np.zeros((count, 2))])
        zigzag = line.copy()
        zigzag[:, 1] += 0.03 * np.tile([1.0, -1.0, -1.0, 1.0], count // 4)
        result = evaluation.trajectory_error(trajectory(zigzag), trajectory(line))
        self.assertAlmostEqual(result.rmse, 0.03, places=6)

    def test_poses_in_a_gap_of_truth_do_not_count(self):
        bad = self.poses.copy()
        bad[100:120, 0] += 5.0
        keep = np.ones(400, dtype=bool)
        keep[99:121] = False
        reference = trajectory(self.poses)
        gap = Trajectory(reference.stamps[keep], reference.poses[keep])
        result = evaluation.trajectory_error(trajectory(bad), gap)
        self.assertLess(result.max, 1e-9)
        self.assertEqual(np.count_nonzero(result.valid), 400 - 22)
        self.assertGreater(evaluation.trajectory_error(trajectory(bad), reference).max, 4.0)

    def test_truth_of_another_time_gives_no_figure(self):
        later = Trajectory(self.estimate.stamps + 10 ** 12, self.poses)
        self.assertIsNone(evaluation.trajectory_error(self.estimate, later))


class PositionError(unittest.TestCase):
    """Fixes of an antenna, without headings and with outages."""

    def setUp(self):
        self.poses = run_maker.ring(400)
        self.estimate = trajectory(self.poses)
        world = se2.transform_poses(T, self.poses)
        antenna = np.array([se2.compose(pose, (3.78, 0.5, 0.0)) for pose in world])
        antenna[:, 2] = np.nan
        keep = np.r_[0:100:7, 200:400:10]  # 1 Hz and less, and ten seconds without any
        stamps = self.estimate.stamps[keep]
        self.truth = Trajectory(stamps, antenna[keep], (3.78, 0.5))

    def test_an_antenna_ahead_of_the_robot_costs_nothing(self):
        result = evaluation.trajectory_error(self.estimate, self.truth)
        self.assertLess(result.max, 1e-9)
        self.assertEqual(len(result.errors), len(self.truth))
        np.testing.assert_allclose(result.T_truth_map, T, atol=1e-9)
        without_its_point = Trajectory(self.truth.stamps, self.truth.poses)
        self.assertGreater(evaluation.trajectory_error(self.estimate, without_its_point).max, 1.0)

    def test_an_error_of_a_fix_is_that_of_its_place(self):
        self.truth.poses[5, 0] += 8.0
        result = evaluation.trajectory_error(self.estimate, self.truth)
        self.assertEqual(int(np.argmax(result.errors)), 5)
        self.assertAlmostEqual(result.max, 8.0, delta=0.5)

    def test_fixes_between_poses_are_compared_with_the_pose_between(self):
        line = np.column_stack([np.arange(11.0), np.zeros((11, 2))])
        fixes = Trajectory(np.array([50_000_000, 450_000_000]),
                           np.array([[0.5, 0.0, np.nan], [4.5, 0.0, np.nan]]))
        self.assertLess(evaluation.trajectory_error(trajectory(line), fixes).max, 1e-9)

    def test_gives_none_of_the_figures_that_take_a_heading(self):
        run = RunFolder(pathlib.Path("run"), self.estimate, truth=self.truth,
                        odometry=self.estimate,
                        updates=updates(self.estimate, np.tile(np.eye(3), (400, 1, 1))))
        metrics = evaluation.evaluate(run).metrics
        self.assertIn("ate_rmse_m", metrics)
        self.assertIn("odometry_ate_rmse_m", metrics)
        for key in ("nees_mean", "ate_unaligned_rmse_m", "odometry_drift_percent"):
            self.assertNotIn(key, metrics)


class LandmarkError(unittest.TestCase):

    def setUp(self):
        self.true = np.random.default_rng(2).uniform(-5.0, 5.0, (20, 2))

    def test_landmarks_are_matched_by_id_and_aligned_on_their_own(self):
        order = np.random.default_rng(3).permutation(20)
        estimate = landmark_map(order, se2.transform_points(T, self.true[order]))
        result = evaluation.landmark_error(estimate, landmark_map(range(20), self.true))
        self.assertLess(result.rmse, 1e-9)

    def test_landmarks_that_only_one_side_knows_are_left_out(self):
        estimate = landmark_map([1, 2, 3, 99], [[0, 0], [1, 0], [0, 1], [50, 50]])
        truth = landmark_map([1, 2, 3, 7], [[0, 0], [1, 0], [0, 1], [9, 9]])
        result = evaluation.landmark_error(estimate, truth)
        self.assertEqual(result.ids, [1, 2, 3])
        self.assertLess(result.rmse, 1e-9)

    def test_a_pair_that_is_too_far_apart_has_half_the_difference_as_error(self):
        estimate = landmark_map([1, 2], [[0.0, 0.0], [3.2, 0.0]])
        truth = landmark_map([1, 2], [[0.0, 0.0], [0.0, 3.0]])
        self.assertAlmostEqual(evaluation.landmark_error(estimate, truth).rmse, 0.1)

    def test_one_match_is_too_few(self):
        one = landmark_map([1], [[0.0, 0.0]])
        self.assertIsNone(evaluation.landmark_error(one, one))

    def test_ids_of_the_runs_own_are_not_compared_with_those_of_ground_truth(self):
        estimate = landmark_map(range(20), self.true)
        estimate.has_own_ids = True
        self.assertIsNone(evaluation.landmark_error(estimate, landmark_map(range(20), self.true)))


class Consistency(unittest.TestCase):

    def drawn(self, factor):
        """NEES of errors drawn from a full covariance and claimed factor times smaller."""
        random = np.random.default_rng(11)
        count = 4000
        root = np.array([[0.05, 0.0, 0.0], [0.02, 0.04, 0.0], [-0.01, 0.005, 0.02]])
        true = run_maker.ring(count)
        errors = random.normal(size=(count, 3)) @ root.T
        errors[0] = 0.0
        estimate = true + errors
        P = np.tile(root @ root.T / factor ** 2, (count, 1, 1))
        estimate = trajectory(estimate)
        return evaluation.pose_consistency(estimate, updates(estimate, P),
                                        trajectory(se2.transform_poses(T, true)))

    def test_nees_of_a_consistent_filter_is_three(self):
        nees = self.drawn(1.0).nees
        # Mean of 4000 chi-square variables of 3 dof: 95 % bounds 3 +- 1.96 sqrt(6 / 4000).
        self.assertAlmostEqual(np.mean(nees), 3.0, delta=0.08)
        inside = evaluation.inside_bounds(nees, np.full(len(nees), 3))
        self.assertAlmostEqual(np.mean(inside), 0.95, delta=0.02)

    def test_a_filter_twice_too_sure_has_four_times_the_nees(self):
        self.assertAlmostEqual(np.mean(self.drawn(2.0).nees), 12.0, delta=0.32)

    def test_truth_is_moved_by_its_first_pose_and_not_fitted(self):
        poses = np.zeros((50, 3))
        poses[:, 0] = np.linspace(0.0, 5.0, 50)
        bent = poses.copy()
        bent[0, 2] = 0.1
        estimate = trajectory(bent)
        P = np.tile(np.eye(3), (50, 1, 1))
        result = evaluation.pose_consistency(estimate, updates(estimate, P), trajectory(poses))
        self.assertAlmostEqual(result.errors[-1, 1], -5.0 * np.sin(0.1))
        np.testing.assert_allclose(result.errors[0], 0.0, atol=1e-12)

    def test_heading_error_is_wrapped(self):
        true = np.zeros((3, 3))
        true[1:, 2] = 3.1
        estimate = true.copy()
        estimate[2, 2] = -3.1
        estimate = trajectory(estimate)
        P = np.tile(np.eye(3), (3, 1, 1))
        result = evaluation.pose_consistency(estimate, updates(estimate, P), trajectory(true))
        self.assertAlmostEqual(result.errors[2, 2], 2.0 * np.pi - 6.2)

    def test_lines_with_a_singular_covariance_are_skipped(self):
        estimate = trajectory(run_maker.ring(10))
        P = np.tile(1e-4 * np.eye(3), (10, 1, 1))
        P[0] = 0.0
        P[5, 2, 2] = 1e-19
        result = evaluation.pose_consistency(estimate, updates(estimate, P), estimate)
        self.assertEqual(np.flatnonzero(~result.valid).tolist(), [0, 5])
        np.testing.assert_allclose(result.nees, 0.0, atol=1e-12)

    def test_nis_is_weighted_by_degrees_of_freedom(self):
        steps = updates(trajectory(np.zeros((3, 3))), np.zeros((3, 3, 3)))
        steps.nis, steps.nis_dof = np.array([4.0, 0.0, 2.0]), np.array([2, 0, 4])
        self.assertAlmostEqual(evaluation.nis_mean(steps), 1.0)

    def test_bounds_are_those_of_each_steps_own_degrees_of_freedom(self):
        inside = evaluation.inside_bounds(np.array([0.06, 0.06, 9.0, 9.0]), np.array([2, 4, 2, 4]))
        self.assertEqual(inside.tolist(), [True, False, False, True])

    def test_without_used_observations_there_is_no_nis(self):
        steps = updates(trajectory(np.zeros((3, 3))), np.zeros((3, 3, 3)))
        self.assertIsNone(evaluation.nis_mean(steps))


class RevisedPath(unittest.TestCase):

    def setUp(self):
        self.truth = run_maker.ring(400)
        online = self.truth.copy()
        online[200:, 1] += 0.2  # what a loop then corrects
        revised = self.truth.copy()
        revised[::2, 0] += 0.02
        self.run = RunFolder(pathlib.Path("."), trajectory(online), truth=trajectory(self.truth),
                             final=trajectory(revised))

    def test_has_an_error_of_its_own(self):
        metrics = evaluation.evaluate(self.run).metrics
        self.assertAlmostEqual(metrics["ate_final_rmse_m"], 0.01, places=4)
        self.assertGreater(metrics["ate_rmse_m"], 0.05)

    def test_that_was_not_written_has_none(self):
        self.run.final = None
        self.assertNotIn("ate_final_rmse_m", evaluation.evaluate(self.run).metrics)

    def test_without_truth_has_none(self):
        self.run.truth = None
        self.assertNotIn("ate_final_rmse_m", evaluation.evaluate(self.run).metrics)

    def test_is_told_in_the_report(self):
        self.assertIn("ate_final_rmse_m", KEYS)


class Merge(unittest.TestCase):

    def test_keeps_what_the_run_wrote_and_drops_old_figures(self):
        merged = merge({"cpu_s": 1.5, "ate_rmse_m": 9.0, "own": 1}, {"landmarks": 3})
        self.assertEqual(merged, {"cpu_s": 1.5, "own": 1, "landmarks": 3})


if __name__ == "__main__":
    unittest.main()
