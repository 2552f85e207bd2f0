# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables and figures of the benchmark grid, without running any of them."""
import pathlib
import tempfile
import types
import unittest

from slam_eval.bench import command_line
from slam_eval.bench.cli import BENCHMARKS
from slam_eval.bench.grid import intel, office, scan, sena
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.goals import verdicts
from slam_eval.bench.harness.table import Section
from slam_eval.bench.peers import rbpf_slam
import numpy as np

SCAN_NAMES = ("scanOfGrid/particles:30/threads:1/beams:180/metres:50/iterations:100/process_time"
              "/real_time\n"
              "scanOfGrid/particles:10/threads:1/beams:180/metres:50/iterations:100/process_time"
              "/real_time\n"
              "scanOfGrid/particles:30/threads:4/beams:180/metres:50/iterations:100/process_time"
              "/real_time\n")


class Verdicts(unittest.TestCase):

    def rows(self, **changed):
        """Two seeds of part intel; the second one with other values."""
        good = dict(zip(intel.HEADER,
                        ["1", 2984, 0.05, 0.05, 2.0, 30.0, 31.0, 150.0]))
        return [list(good.values()), list({**good, **changed}.values())]

    def test_every_seed_has_to_keep_to_the_limits(self):
        def words(rows):
            return verdicts(intel.GOALS, intel.HEADER, rows)
        self.assertEqual(words(self.rows()).count("reached"), 4)
        self.assertNotIn("MISSED", words(self.rows()))
        missed = words(self.rows(**{"translation [m]": 0.068, "memory [MB]": 250.0}))
        self.assertEqual(missed.count("MISSED"), 2)
        self.assertIn("worst translation [m] 0.068", missed)

    def test_shares_have_to_be_at_least_the_limit(self):
        row = ["1", 0.05, 2.0, 96.0, 89.0, 5.0, 90.0]
        alone, both = (verdicts(case.goals, office.HEADER, [row])
                       for case in office.CASES)
        self.assertIn("worst walls found [%] 89 (>= 90: MISSED)", alone)
        self.assertEqual((alone.count("reached"), both.count("reached")), (2, 1))

    def test_a_figure_that_is_missing_has_no_verdict(self):
        row = ["1", 0.02, 2.0, None, 91.0, 5.0, 90.0]
        words = verdicts(office.CASES[0].goals, office.HEADER,
                                    [row])
        self.assertEqual(len(words.splitlines()), 2)


class Scans(unittest.TestCase):

    def test_the_sizes_stand_in_the_names_of_the_benchmarks(self):
        sizes = scan.parse_cases(SCAN_NAMES)
        self.assertEqual([size["particles"] for size in sizes], [30, 10, 30])
        self.assertEqual(sizes[2]["threads"], 4)

    def test_only_one_number_varies_in_a_table(self):
        cases = [scan.Case(size, 1.0, 1.0, 50.0)
                 for size in scan.parse_cases(SCAN_NAMES)]
        self.assertEqual([case.size["particles"] for case in
                          scan.against(cases, "particles")], [10, 30])
        self.assertEqual([case.size["threads"] for case in
                          scan.against(cases, "threads")], [1, 4])


class RbpfSlam(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.addCleanup(setattr, rbpf_slam, "CONFIGURATIONS", rbpf_slam.CONFIGURATIONS)
        rbpf_slam.CONFIGURATIONS = self.folder

    def test_values_of_the_shipped_configuration_are_replaced(self):
        (self.folder / "a.ini").write_text("[x]\nsampleSize=25\t// size\nother = 1\n")
        text = rbpf_slam.configuration("a.ini", {"sampleSize": 10})
        self.assertEqual(text, "[x]\nsampleSize = 10\nother = 1\n")
        with self.assertRaisesRegex(BenchError, "has no missing"):
            rbpf_slam.configuration("a.ini", {"missing": 1})
        with self.assertRaisesRegex(BenchError, "install mrpt-common"):
            rbpf_slam.configuration("b.ini", {})


class Parts(unittest.TestCase):

    def test_intel_is_left_out_where_its_files_are_not(self):
        with tempfile.TemporaryDirectory() as name:
            options = types.SimpleNamespace(laser=pathlib.Path(name))
            section = intel.measure(types.SimpleNamespace(options=options))
        self.assertIsInstance(section, Section)
        self.assertIn("Left out: there is no file", section.paragraphs[0])

    def test_dead_reckoning_is_compared_from_the_same_start(self):
        run = types.SimpleNamespace(
            odometry=types.SimpleNamespace(poses=np.array([[5.0, 5.0, np.pi], [3.0, 5.0, np.pi]])),
            trajectory=types.SimpleNamespace(poses=np.array([[0.0, 0.0, 0.0], [2.0, 1.0, 0.0]])))
        self.assertAlmostEqual(sena.odometry_error(run), 1.0)
        run.odometry = None
        self.assertIsNone(sena.odometry_error(run))

    def test_options_name_the_parts(self):
        options = command_line.parse(["grid", "--only", "sena,intel", "--seeds", "2"],
                                      BENCHMARKS)
        self.assertEqual((options.only, options.seeds), (["intel", "sena"], 2))


if __name__ == "__main__":
    unittest.main()
