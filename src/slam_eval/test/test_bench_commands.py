# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

from slam_eval.bench.ekf import commands
from slam_eval.bench.harness.table import lines_of


class Commands(unittest.TestCase):
    def test_figures_are_means_and_what_is_confidently_wrong_is_summed_up(self):
        drives = [{"odometry_ate_rmse_m": 1.0, "ate_rmse_m": 0.01, "nees_mean": 2.0,
                   "confidently_wrong_s": 0.5},
                  {"odometry_ate_rmse_m": 3.0, "ate_rmse_m": 0.03, "nees_mean": 4.0}]
        row = commands.row_of("office", "ekf_command", drives)
        self.assertEqual(len(row), len(commands.HEADER))
        self.assertEqual(lines_of([row], commands.FORMS),
                         [["office, ekf_command", "2.000", "0.0200", "3.00", "0.5"]])


if __name__ == "__main__":
    unittest.main()
