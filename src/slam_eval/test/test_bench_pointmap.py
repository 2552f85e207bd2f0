# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the benchmark pointmap, without running it."""
import json
import unittest

from slam_eval.bench import command_line, pointmap
from slam_eval.bench.cli import BENCHMARKS
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.google import parse_figures


class PointMap(unittest.TestCase):

    def test_the_sizes_stand_in_the_names_of_the_benchmarks(self):
        names = "scanOfPointMap/aligned/points:1000/iterations:300\n"
        self.assertEqual(pointmap.parse_cases(names), [("aligned", 1000)])

    def test_the_time_of_a_scan_into_100000_points_is_judged(self):
        words = pointmap.time_verdicts({("euclidean", 100000): 0.5, ("aligned", 100000): 2.5,
                                              ("aligned", 1000): 9.0})
        self.assertIn("euclidean, 100000 points: 0.50 ms (<= 2: reached)", words)
        self.assertIn("aligned, 100000 points: 2.50 ms (<= 2: MISSED)", words)
        self.assertEqual(len(words.splitlines()), 2)

    def test_output_that_is_no_time_is_refused(self):
        entry = {"real_time": 1.5, "cpu_time": 1.4, "time_unit": "ms"}
        self.assertEqual(parse_figures(json.dumps({"benchmarks": [entry]}), "p",
                                       ("cpu_time", "real_time")), (1.4, 1.5))
        for text in ("", "{}", '{"benchmarks": []}',
                     json.dumps({"benchmarks": [{**entry, "time_unit": "ns"}]}),
                     json.dumps({"benchmarks": [{"time_unit": "ms"}]})):
            with self.subTest(text), self.assertRaisesRegex(BenchError, "p printed no JSON"):
                parse_figures(text, "p", ("cpu_time",))

    def test_options_name_the_parts(self):
        options = command_line.parse(["pointmap"], BENCHMARKS)
        self.assertEqual(options.only, ["scan", "office"])


if __name__ == "__main__":
    unittest.main()
