# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the benchmark pointmap, without running it."""
import json
import unittest

from slam_eval import bench_cli, bench_google, bench_options, bench_pointmap
from slam_eval.bench_error import BenchError


class PointMap(unittest.TestCase):

    def test_the_sizes_stand_in_the_names_of_the_benchmarks(self):
        names = 'scanOfPointMap/aligned/points:1000/iterations:300\n'
        self.assertEqual(bench_pointmap.parse_cases(names), [('aligned', 1000)])

    def test_the_time_of_a_scan_into_100000_points_is_judged(self):
        words = bench_pointmap.time_verdicts({('euclidean', 100000): 0.5, ('aligned', 100000): 2.5,
                                              ('aligned', 1000): 9.0})
        self.assertIn('euclidean, 100000 points: 0.50 ms (<= 2: reached)', words)
        self.assertIn('aligned, 100000 points: 2.50 ms (<= 2: MISSED)', words)
        self.assertEqual(len(words.splitlines()), 2)

    def test_output_that_is_no_time_is_refused(self):
        entry = {'real_time': 1.5, 'cpu_time': 1.4, 'time_unit': 'ms'}
        self.assertEqual(bench_google.parse_entry(json.dumps({'benchmarks': [entry]}), 'p'),
                         entry)
        for text in ('', '{}', '{"benchmarks": []}',
                     json.dumps({'benchmarks': [{**entry, 'time_unit': 'ns'}]})):
            with self.subTest(text), self.assertRaisesRegex(BenchError, 'p printed no JSON'):
                bench_google.parse_entry(text, 'p')

    def test_options_name_the_parts(self):
        options = bench_options.parse(['pointmap'], bench_cli.BENCHMARKS)
        self.assertEqual(options.only, ['scan', 'office'])


if __name__ == '__main__':
    unittest.main()
