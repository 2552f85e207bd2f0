# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""For how long a run was confidently wrong, and for how long it said that it was lost."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.geometry import se2  # noqa: E402
from slam_eval.io.events import Event  # noqa: E402
from slam_eval.io.run_folder import read_run  # noqa: E402
from slam_eval.io.trajectory import Trajectory  # noqa: E402
from slam_eval.io.updates import Updates  # noqa: E402
from slam_eval.metrics import honesty  # noqa: E402
from slam_eval.metrics.evaluation import evaluate  # noqa: E402
from slam_eval.report.metric_table import KEYS  # noqa: E402

STEP = 10 ** 8  # [ns]


def claim(off, sigma, count=101, stamps=None, truth_stamps=None):
    """The claim of a robot that drives along x and is `off` [m] to the left from the second pose
    on; sigma: reported along and across the way [m]."""
    stamps = np.arange(count, dtype=np.int64) * STEP if stamps is None else stamps
    true = np.column_stack([0.05 * np.arange(count), np.zeros((count, 2))])
    seen = true.copy()
    seen[1:, 1] += off
    covariances = np.tile(np.diag([sigma[0] ** 2, sigma[1] ** 2, 1e-4]), (count, 1, 1))
    world = se2.transform_poses(run_maker.T_WORLD_MAP, true)
    truth = Trajectory(stamps, world)
    if truth_stamps is not None:
        truth = Trajectory(stamps[truth_stamps], world[truth_stamps])
    return honesty.position_claim(Trajectory(stamps, seen),
                                  Updates(stamps, covariances, None, None, {}), truth)


class ConfidentlyWrong(unittest.TestCase):

    def test_is_an_error_beyond_both_limits_for_as_long_as_its_poses_stand(self):
        found = claim(0.5, (0.05, 0.05))
        self.assertAlmostEqual(found.errors[50], 0.5)
        self.assertAlmostEqual(found.distances[50], 10.0)
        # The first pose is right by definition, the last one stands for no time.
        self.assertAlmostEqual(found.seconds_wrong, 9.9)

    def test_is_no_error_that_the_covariance_admits(self):
        self.assertEqual(claim(0.5, (0.05, 0.11)).seconds_wrong, 0.0)
        self.assertGreater(claim(0.5, (0.05, 0.09)).seconds_wrong, 0.0)

    def test_is_nothing_where_the_covariance_is_unknown(self):
        stamps = np.arange(5, dtype=np.int64) * STEP
        poses = Trajectory(stamps, np.zeros((5, 3)))
        unknown = Updates(stamps, np.zeros((5, 3, 3)), None, None, {})
        self.assertIsNone(honesty.position_claim(poses, unknown, poses))

    def test_is_no_small_error_however_small_the_covariance(self):
        self.assertEqual(claim(0.29, (0.001, 0.001)).seconds_wrong, 0.0)
        self.assertGreater(claim(0.31, (0.001, 0.001)).seconds_wrong, 0.0)

    def test_looks_along_the_error_and_not_at_the_largest_sigma(self):
        self.assertGreater(claim(0.5, (5.0, 0.05)).seconds_wrong, 0.0)

    def test_is_an_error_without_any_covariance(self):
        found = claim(0.5, (0.0, 0.0))
        self.assertEqual(found.distances[0], 0.0)
        self.assertEqual(found.distances[1], np.inf)
        self.assertAlmostEqual(found.seconds_wrong, 9.9)

    def test_a_pose_without_truth_does_not_count(self):
        found = claim(0.5, (0.05, 0.05), truth_stamps=np.r_[0:30, 60:101])
        self.assertAlmostEqual(found.seconds_wrong, 9.9 - 3.0)

    def test_weighs_poses_by_time(self):
        stamps = np.array([0, 1, 2, 12, 13], dtype=np.int64) * STEP
        found = claim(0.5, (0.05, 0.05), count=5, stamps=stamps)
        self.assertAlmostEqual(found.seconds_wrong, 1.2)
        self.assertAlmostEqual(found.share_wrong(np.array([1, 1, 0, 0, 0], bool)), 0.5)
        self.assertIsNone(found.share_wrong(np.zeros(5, bool)))

    def test_is_a_missed_loss_where_it_lasts_for_more_than_five_seconds(self):
        self.assertEqual(claim(0.5, (0.05, 0.05)).missed_losses, 1)
        self.assertEqual(claim(0.5, (0.05, 0.05), count=50).missed_losses, 0)
        twice = claim(0.5, (0.05, 0.05), count=121)
        twice.errors[60] = 0.1
        self.assertEqual(twice.missed_losses, 2)

    def test_is_not_known_where_truth_has_no_headings_or_another_time(self):
        stamps = np.arange(3, dtype=np.int64) * STEP
        poses = Trajectory(stamps, np.zeros((3, 3)))
        updates = Updates(stamps, np.zeros((3, 3, 3)), None, None, {})
        fixes = Trajectory(stamps, np.array([[0.0, 0.0, np.nan]] * 3))
        later = Trajectory(stamps + 10 ** 12, np.zeros((3, 3)))
        self.assertIsNone(honesty.position_claim(poses, updates, fixes))
        self.assertIsNone(honesty.position_claim(poses, updates, later))


class Lost(unittest.TestCase):

    def intervals(self, *kinds, end=100, state=honesty.LOST):
        """Intervals of events (stamp, kind)."""
        events = [Event(stamp, kind, 0.0, 0.0, "") for stamp, kind in kinds]
        return honesty.intervals_of(state, events, end)

    def test_lasts_until_the_robot_is_found(self):
        self.assertEqual(self.intervals((10, "lost"), (20, "jump"), (30, "found"), (50, "lost"),
                                        (55, "found")), [(10, 30), (50, 55)])

    def test_lasts_to_the_end_where_it_is_not_found(self):
        self.assertEqual(self.intervals((10, "found"), (40, "lost")), [(40, 100)])

    def test_a_doubt_lasts_until_it_ends_or_becomes_a_loss(self):
        self.assertEqual(
            self.intervals((10, "doubtful"), (20, "confident"), (30, "doubtful"), (40, "lost"),
                           (50, "found"), (50, "doubtful"), state=honesty.DOUBTFUL),
            [(10, 20), (30, 40), (50, 100)])

    def test_is_no_time_where_nothing_says_so(self):
        self.assertEqual(self.intervals((10, "jump")), [])


class Runs(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name) / "run"

    def metrics(self, events="", stored=None, **arguments):
        """The metrics of a run that run_maker made. events: lines of events.csv, None for no file."""
        run_maker.make_run(self.folder, count=200, **arguments)
        if events is not None:
            (self.folder / "events.csv").write_text("stamp,kind,distance,turn,reason\n" + events)
        run = read_run(self.folder)
        run.metrics.update(stored or {})
        return evaluate(run).metrics

    def test_an_honest_run_is_never_confidently_wrong(self):
        self.assertEqual(self.metrics()["confidently_wrong_s"], 0.0)

    def test_without_truth_nobody_knows_whether_a_pose_is_wrong(self):
        self.assertNotIn("confidently_wrong_s", self.metrics(truth=False))

    def test_the_time_lost_is_that_of_the_events(self):
        lines = '1002.0,lost,0,0,"a"\n1005.5,found,0,0,"b"\n1030.0,lost,0,0,"c"\n'
        self.assertAlmostEqual(self.metrics(lines)["lost_s"], 3.5 + 39.8 - 30.0)
        self.assertAlmostEqual(self.metrics(lines, truth=False)["lost_s"], 12.8 + 0.5)

    def test_a_loss_is_false_where_the_position_was_right(self):
        lines = '1002.0,lost,0,0,"a"\n1005.5,found,0,0,"b"\n1030.0,lost,0,0,"c"\n'
        self.assertNotIn("lost_false", self.metrics(lines, truth=False))
        self.assertEqual(self.metrics(lines)["lost_false"], 2)
        self.assertNotIn("lost_false", self.metrics())
        estimate = self.folder / "trajectory.tum"
        moved = [line.split() for line in estimate.read_text().splitlines()]
        estimate.write_text("".join(
            " ".join([t, str(float(x) + 2.0 * (float(t) > 1020.0)), *rest]) + "\n"
            for t, x, *rest in moved))
        (self.folder / "events.csv").write_text("stamp,kind,distance,turn,reason\n" + lines)
        self.assertEqual(evaluate(read_run(self.folder)).metrics["lost_false"], 1)

    def test_a_run_that_can_tell_and_does_not_was_never_lost(self):
        self.assertEqual(self.metrics(stored={"lost_alarms": 0})["lost_s"], 0.0)

    def test_a_run_that_cannot_tell_has_no_time_lost(self):
        self.assertNotIn("lost_s", self.metrics())
        (self.folder / "events.csv").unlink()
        self.assertNotIn("lost_s", self.metrics(events=None, stored={"lost_alarms": 0}))

    def test_both_are_told_in_the_report(self):
        self.assertEqual(KEYS["confidently_wrong_s"].unit, "s")
        self.assertEqual(KEYS["lost_s"].unit, "s")
        self.assertEqual(KEYS["doubtful_s"].unit, "s")


if __name__ == "__main__":
    unittest.main()
