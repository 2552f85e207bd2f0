# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables and verdicts of benchmark pf."""
import json
import pathlib
import tempfile
import unittest

import numpy as np

from slam_eval.bench import threads
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.google import parse_figures
from slam_eval.bench.pf import mrclam, office, update
from slam_eval.bench.pf.update import Size
from slam_eval.bench.pf.variants import DEFAULT, EKF, FEW, MANY


class UpdateTest(unittest.TestCase):
    def test_sizes_are_read_from_the_list_of_benchmarks(self):
        text = "updateOfPf/particles:100/landmarks:1000\nupdateOfPf/particles:10/landmarks:100\n"
        self.assertEqual(update.parse_sizes(text), [(10, 100), (100, 1000)])

    def test_time_and_share_are_read_from_json(self):
        entry = {"name": "x", "cpu_time": 2.5, "time_unit": "ms", "resampled": 0.25}
        self.assertEqual(parse_figures(json.dumps({"benchmarks": [entry]}),
                                       update.PROGRAM, update.FIGURES), (2.5, 0.25))

    def test_what_is_no_json_of_the_benchmark_is_said(self):
        for text in ("", "{}", '{"benchmarks": []}',
                     '{"benchmarks": [{"cpu_time": 1, "time_unit": "s", "resampled": 0}]}'):
            with self.assertRaisesRegex(BenchError, "slam_eval_pf_update"):
                parse_figures(text, update.PROGRAM, update.FIGURES)

    def test_goals_are_judged_at_their_sizes_only(self):
        sizes = [Size(100, 1000, 20.0, 0.1, 50.0), Size(1000, 1000, 90.0, 0.1, 250.0)]
        text = update.verdicts(sizes)
        self.assertIn("50 updates a second (>= 100: MISSED)", text)
        self.assertIn("250 MB (<= 300: reached)", text)
        self.assertIn("4.50 times the time (<= 10: reached)", text)
        self.assertEqual(update.verdicts([Size(10, 100, 1.0, 0.0, 9.0)]), "")


class MrclamTest(unittest.TestCase):
    def test_a_line_holds_means_and_the_worst_run(self):
        rows = np.array([[0.2, 0.1, 0.2, 1.0, 4.0], [0.4, 0.2, 0.2, 1.0, 6.0]])
        np.testing.assert_allclose(mrclam.summary(rows), [0.3, 0.4, 0.15, 0.2, 1.0, 5.0])

    def test_every_goal_is_judged(self):
        def line(ate, landmarks):
            return [ate, ate, landmarks, ate, 1.0, 1.0]
        text = mrclam.verdicts({
            EKF.name: line(0.2, 0.1), DEFAULT.name: line(0.21, 0.14),
            FEW.name: line(0.24, 0.1), MANY.name: line(0.2, 0.1)})
        self.assertEqual([line.endswith("reached)") for line in text.splitlines()],
                         [True, True, False, False])


class OfficeTest(unittest.TestCase):
    def test_a_line_holds_means_the_worst_drive_and_the_fewest_markers(self):
        rows = [[0.02, 0.01, 12, 12, 1.0, 4.0], [0.04, 0.03, 11, 12, 2.0, 6.0]]
        values = office.summary(rows)
        np.testing.assert_allclose(values, [0.03, 0.04, 0.02, 11, 12, 1.5, 5.0])

    def test_a_drive_without_a_map_makes_no_mean_of_landmarks(self):
        rows = [[0.02, None, 0, 12, None, 4.0], [0.04, 0.03, 11, 12, 2.0, 6.0]]
        self.assertEqual(office.summary(rows)[2:6], [None, 0, 12, None])

    def test_every_goal_is_judged(self):
        def line(ate, worst, mapped):
            return [ate, worst, 0.01, mapped, 12, 1.0, 4.0]
        text = office.verdicts({DEFAULT.name: line(0.02, 0.031, 12),
                                         FEW.name: line(0.021, 0.04, 12),
                                         MANY.name: line(0.02, 0.04, 12)})
        self.assertEqual([line.endswith("reached)") for line in text.splitlines()],
                         [False, True, True])


class ThreadsTest(unittest.TestCase):
    def test_one_byte_makes_a_difference(self):
        def run(folder, text):
            for name in threads.FILES:
                (folder / name).write_text("same", encoding="ascii")
            (folder / threads.FILES[-1]).write_text(text, encoding="ascii")
            return threads.digests(folder)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            a, b, c = run(folder, "map"), run(folder, "map"), run(folder, "mop")
        self.assertIn("reached", threads.verdict([(1, a), (2, b)]))
        self.assertIn("MISSED", threads.verdict([(1, a), (2, c)]))


if __name__ == "__main__":
    unittest.main()
