# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the runs of the benchmark adverse are judged, and its table."""
import pathlib
import tempfile
import types
import unittest

import numpy as np
from slam_eval.bench.adverse import drives, results
from slam_eval.bench.adverse.faults import FAULTS
from slam_eval.bench.harness import judge
from slam_eval.bench.harness.error import BenchError, Failure
from slam_eval.bench.harness.hall_drives import LANDMARKS, SCANS
from slam_eval.bench.harness.judge import Outcome
from slam_eval.io.events import Event
from slam_eval.io.trajectory import Trajectory
from slam_eval.io.updates import Updates
from slam_eval.plot.adverse import plot_shares


def run(off, events=(), count=400, sigma=0.01):
    """A robot that drives along x for 40 s; off: [(first, last step, error [m])]."""
    stamps = np.arange(count, dtype=np.int64) * 10 ** 8
    true = np.column_stack([0.05 * np.arange(count), np.zeros((count, 2))])
    seen = true.copy()
    for first, last, error in off:
        seen[first:last, 1] += error
    covariances = np.tile(np.diag([sigma ** 2, sigma ** 2, 1e-4]), (count, 1, 1))
    zeros = np.zeros(count)
    return types.SimpleNamespace(
        trajectory=Trajectory(stamps, seen), truth=Trajectory(stamps, true), final=None,
        odometry=None, wheels=None, landmarks=None, true_landmarks=None, grid=None, points=None,
        updates=Updates(stamps, covariances, zeros, zeros.astype(int), {}), places=None, metrics={},
        events=[Event(int(time * 1e9), kind, 0.0, 0.0, "") for time, kind in events])


class Judge(unittest.TestCase):

    def test_what_is_wrong_before_the_fault_has_settled_does_not_count(self):
        # 15 s are left from 25 s on; the last pose stands for no time.
        self.assertEqual(judge.judge(run([(210, 250, 1.0)]), 20.0).wrong, 0.0)
        found = judge.judge(run([(210, 330, 1.0)]), 20.0)
        self.assertAlmostEqual(found.wrong, 8.0 / 14.9)
        self.assertAlmostEqual(found.largest, 1.0)
        self.assertAlmostEqual(found.nees, 1e4)

    def test_an_error_that_the_run_admits_is_not_confident(self):
        self.assertEqual(judge.judge(run([(210, 400, 1.0)], sigma=0.5), 20.0).wrong, 0.0)

    def test_lost_counts_from_the_fault_on(self):
        found = judge.judge(run([], [(5.0, "lost"), (6.0, "found"), (22.0, "lost"),
                                     (25.0, "found"), (38.9, "lost")]), 20.0)
        self.assertEqual((found.told, found.false), (2.0, 1))
        self.assertAlmostEqual(found.lost, 3.0 + 1.0)

    def test_a_robot_that_is_lost_already_is_told_at_once(self):
        found = judge.judge(run([], [(18.0, "lost")]), 20.0)
        self.assertEqual((found.told, found.false), (0.0, 1))

    def test_a_robot_that_is_never_told_lost_has_no_time(self):
        found = judge.judge(run([]), 20.0)
        self.assertIsNone(found.told)
        self.assertEqual(found.lost, 0.0)


def outcome(wrong, told=None, false=0):
    """An Outcome of a run."""
    return Outcome(0.5, 1.5, 4.0, wrong, told, 0.0 if told is None else 3.0, false)


class Tables(unittest.TestCase):

    def cells(self, outcomes):
        """{column: text} of a line."""
        return dict(zip(results.HEADER, results.row("ekf_wheel", "carried", outcomes)))

    def test_a_line_has_medians_and_the_worst_seed(self):
        cells = self.cells([outcome(0.0), outcome(0.02, 4.0, 1), outcome(0.5, 6.0)])
        self.assertEqual(cells["wrong [%]"], "2.0")
        self.assertEqual(cells["worst [%]"], "50.0")
        self.assertEqual(cells["lost reported"], "2 of 3")
        self.assertEqual(cells["after [s]"], "5.0")
        self.assertEqual(cells["lost [s]"], "3.0")
        self.assertEqual(cells["reported before"], "1")
        self.assertEqual(cells["failed"], "-")

    def test_runs_that_failed_count_as_such_alone(self):
        cells = self.cells([outcome(0.0), Failure("no pose")])
        self.assertEqual((cells["worst [%]"], cells["failed"]), ("0.0", "1"))
        cells = self.cells([Failure("no pose")])
        self.assertEqual((cells["worst [%]"], cells["lost reported"], cells["failed"]), ("-", "-", "1"))

    def test_what_is_above_the_limit_is_named_the_worst_first(self):
        lines = results.verdict_lines({
            ("ekf_wheel", "clean"): [outcome(0.0), outcome(0.01)],
            ("ekf_wheel", "carried"): [outcome(0.0), outcome(0.011)],
            ("pf_wheel", "carried"): [outcome(0.4)],
            ("pf_wheel", "clean"): [outcome(0.0), Failure("slam_offline ended with exit code 1")]})
        self.assertEqual(lines.splitlines(), [
            "- confidently wrong at most 1 % of the time with every seed: 1 of 4 cells (MISSED)",
            "- above 1 %: pf_wheel, carried: 40.0 %",
            "- above 1 %: ekf_wheel, carried: 1.1 %",
            "- failed: pf_wheel, clean: 1 of 2 runs: slam_offline ended with exit code 1"])
        lines = results.verdict_lines({("ekf_wheel", "clean"): [outcome(0.0)]})
        self.assertIn("1 of 1 cells (reached)", lines)

    def test_the_picture_takes_cells_that_are_missing_or_failed(self):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "wrong.png"
            plot_shares({("a", "x"): (0.2, 0.9, False), ("b", "x"): (None, None, True)},
                        ["a", "b"], ["x", "y"], path)
            self.assertEqual(path.read_bytes()[:4], b"\x89PNG")

    def test_every_fault_concerns_some_sensor_and_is_a_part(self):
        self.assertEqual(list(drives.PARTS), list(FAULTS))
        for fault in FAULTS.values():
            self.assertTrue(set(fault.sensors) <= {LANDMARKS, SCANS} and fault.sensors)

    def test_a_product_says_by_its_features_what_it_sees(self):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "mine.yaml"
            for features, expected in (("map: grid\nodometry: wheel\ndetector: none", SCANS),
                                       ("map: landmarks\nodometry: wheel", LANDMARKS)):
                path.write_text(features)
                self.assertEqual(drives.sensor_of(str(path)), expected)
            path.write_text("map: landmarks\nodometry: visual")
            with self.assertRaisesRegex(BenchError, "give others with --products"):
                drives.sensor_of(str(path))
            with self.assertRaisesRegex(BenchError, "there is no product"):
                drives.sensor_of(f"{name}/absent.yaml")


if __name__ == "__main__":
    unittest.main()
