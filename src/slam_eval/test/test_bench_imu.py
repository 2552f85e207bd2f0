# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark imu: what is read of the program, and a line of the table."""
import json
import unittest

from slam_eval.bench import imu
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.goals import verdicts


def drive(wheels, with_imu):
    return {"wheel": {"rotation_rad_per_m": wheels, "nees": 9.0, "nees_of_pieces": 9.0},
            "wheel_imu": {"rotation_rad_per_m": with_imu, "nees": 2.0, "nees_of_pieces": 4.0}}


class BenchImu(unittest.TestCase):
    def test_reads_the_programs_figures(self):
        told = [{"name": name, **figures} for name, figures in drive(0.1, 0.01).items()]
        self.assertEqual(imu.parse_result(json.dumps({"odometry": told}))["wheel"]["nees"], 9.0)
        for text in ("", "{}", json.dumps({"odometry": told[:1]})):
            with self.assertRaises(BenchError):
                imu.parse_result(text)

    def test_compares_the_means_of_all_drives(self):
        row = imu.row_of("office", 0.5, [drive(0.1, 0.01), drive(0.3, 0.03)])
        self.assertEqual(row[:2], ["office", 2.0])
        self.assertAlmostEqual(row[4], 0.1)
        self.assertEqual(row[5:], [2.0, 4.0])
        self.assertIn("worst share 0.1", verdicts(imu.GOALS, imu.HEADER, [row]))


if __name__ == "__main__":
    unittest.main()
