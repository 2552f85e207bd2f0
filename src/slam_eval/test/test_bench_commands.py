# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

from slam_eval.bench.ekf import commands
from slam_eval.bench.harness.table import lines_of


class Commands(unittest.TestCase):
    def test_a_figure_is_the_mean_and_missing_where_a_drive_has_none(self):
        drives = [{"odometry_ate_rmse_m": 1.0, "ate_rmse_m": 0.01, "nees_mean": 2.0,
                   "confidently_wrong_s": 0.5},
                  {"odometry_ate_rmse_m": 3.0, "ate_rmse_m": 0.03, "nees_mean": 4.0}]
        row = commands.row_of("office", "ekf_command", drives)
        self.assertEqual(len(row), len(commands.HEADER))
        self.assertEqual(lines_of([row], commands.FORMS),
                         [["office, ekf_command", "2.000", "0.0200", "3.00", "-"]])


if __name__ == "__main__":
    unittest.main()
