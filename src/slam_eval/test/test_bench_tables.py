# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables, options and figures of the benchmarks, without running any of them."""
import argparse
import configparser
import contextlib
import io
import json
import pathlib
import tempfile
import types
import unittest

from slam_eval.bench import cli, command_line
from slam_eval.bench.ekf import consistency, growth, landmarks, update
from slam_eval.bench.harness import table
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.process import Usage
from slam_eval.bench.harness.progress import Progress
from slam_eval.bench.peers import mrpt_config as mrpt
from slam_eval.bench.peers.kf_slam import Result


def result(cpu_s, mean_m, matched=90):
    """A run of so much CPU time and so large an error."""
    return Result(Usage(cpu_s, 2 * cpu_s, 30.0), {"mean_m": mean_m, "aligned_mean_m": mean_m / 2,
                                                     "matched": matched})


class Table(unittest.TestCase):

    def test_lines_are_aligned_and_numbers_stand_to_the_right(self):
        lines = table.table(["name", "x [m]"], [["a", "1.5"], ["longer", "12.25"]])
        self.assertEqual(lines.split("\n"), ["| name   | x [m] |", "|--------|------:|",
                                             "| a      |   1.5 |", "| longer | 12.25 |"])

    def test_a_column_of_dashes_is_left_out(self):
        header, rows = table.drop_empty(["a", "b", "c"], [["1", "-", "-"], ["2", "-", "3"]])
        self.assertEqual((header, rows), (["a", "c"], [["1", "-"], ["2", "3"]]))

    def test_a_missing_number_is_a_dash(self):
        self.assertEqual([table.number(v, ".2f") for v in (None, 0.0)], ["-", "0.00"])

    def test_the_mean_of_a_column_with_a_gap_is_missing(self):
        self.assertEqual(table.mean_row("mean", [["1", 2.0, 1.0], ["2", 4.0, None]]),
                         ["mean", 3.0, None])

    def test_a_verdict_says_whether_the_limit_is_kept(self):
        self.assertIn("reached", table.verdict(1.05, 1.05, at_most=True))
        self.assertIn("MISSED", table.verdict(1.06, 1.05, at_most=True))
        self.assertIn("MISSED", table.verdict(29.0, 30.0, at_most=False))

    def test_pictures_stand_only_on_the_page_relative_to_it(self):
        section = table.Section("T", ["text"], {"p": pathlib.Path("/out/p.png")})
        self.assertNotIn("p.png", section.markdown())
        self.assertIn("![p](p.png)", section.markdown(pathlib.Path("/out")))


class Options(unittest.TestCase):

    def test_sizes_are_sorted_and_taken_once(self):
        self.assertEqual(command_line.number_list("300,100,300"), (100, 300))

    def test_a_size_that_is_no_number_above_0_is_refused(self):
        for text in ("", "100,", "0", "-5", "1.5", "many"):
            with self.subTest(text), self.assertRaises(argparse.ArgumentTypeError):
                command_line.number_list(text)

    def test_parts_run_in_their_own_order(self):
        known = cli.BENCHMARKS["ekf"].parts
        self.assertEqual(command_line.part_list("update,demo", known), ["demo", "update"])

    def test_an_unknown_part_is_refused_with_the_known_ones(self):
        known = cli.BENCHMARKS["ekf"].parts
        with self.assertRaisesRegex(argparse.ArgumentTypeError, "demos.*consistency"):
            command_line.part_list("demo,demos", known)

    def parse(self, *arguments):
        """The options of a call."""
        return command_line.parse(list(arguments), cli.BENCHMARKS)

    def test_without_a_name_the_back_end_is_measured(self):
        self.assertEqual(self.parse().benchmark, "ekf")
        self.assertEqual(self.parse("--only", "demo").only, ["demo"])

    def test_each_benchmark_has_its_own_options(self):
        self.assertEqual((self.parse("ekf").seeds, self.parse("office").seeds), (50, 20))
        self.assertEqual(self.parse("office", "--world", "corridor").world, "corridor")
        self.assertEqual(self.parse("online").composition, "pubsub")

    def test_a_name_or_option_that_does_not_exist_is_wrong_use(self):
        for arguments in (["offce"], ["office", "--sizes", "1"], ["online", "--bag", "/none.bag"]):
            with self.subTest(arguments), contextlib.redirect_stderr(io.StringIO()):
                with self.assertRaises(SystemExit) as wrong_use:
                    self.parse(*arguments)
                self.assertEqual(wrong_use.exception.code, 2)


class Parts(unittest.TestCase):

    def run_parts(self, parts, folder):
        """Run the given functions as parts; returns (failed, text of the page)."""
        page = folder / "page.md"
        context = types.SimpleNamespace(out=folder, progress=Progress())
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            failed = cli.run_parts(parts, list(parts), context, page, "# Title\n")
        return failed, page.read_text(encoding="utf-8")

    def test_a_part_that_fails_does_not_keep_the_others_from_running(self):
        def failing(_):
            raise BenchError("no such thing")

        with tempfile.TemporaryDirectory() as folder:
            failed, text = self.run_parts(
                {"first": failing, "second": lambda _: table.Section("Second")},
                pathlib.Path(folder))
        self.assertEqual(failed, ["first"])
        self.assertIn("## Second", text)

    def test_a_part_of_several_sections_shows_each_and_what_failed_in_it(self):
        def several(_):
            yield table.Section("First", failures=["no such log"])
            yield table.Section("Second")

        with tempfile.TemporaryDirectory() as folder:
            failed, text = self.run_parts({"several": several}, pathlib.Path(folder))
        self.assertEqual(failed, ["several"])
        self.assertIn("Failed: no such log", text)
        self.assertIn("## Second", text)


class MrptConfiguration(unittest.TestCase):

    def read(self, text):
        """The file as kf-slam reads it."""
        parser = configparser.ConfigParser()
        parser.read_string(text)
        return parser

    def test_the_simulated_box_is_30_m_wide_and_holds_the_landmarks(self):
        box = self.read(mrpt.simulation_ini(mrpt.World(300), "w.rawlog"))["RANDOMSET_1"]
        self.assertEqual(box.getint("nLandmarks"), 300)
        self.assertEqual(box.getfloat("max_x") - box.getfloat("min_x"), 30.0)
        self.assertEqual(box.getfloat("max_y") - box.getfloat("min_y"), 30.0)

    def test_kf_slam_saves_the_map_of_the_last_step(self):
        world = mrpt.World(100, steps=600)
        ini = self.read(mrpt.kf_slam_ini(world.last_step))
        self.assertEqual(ini["MappingApplication"].getint("SAVE_LOG_FREQUENCY"), 598)
        self.assertEqual(mrpt.scene_name(world.last_step), "kf_state_00598.3Dscene")

    def test_kf_slam_gets_the_sigmas_it_is_given(self):
        ini = self.read(mrpt.kf_slam_ini(598, 0.01, 0.2))["RangeBearingKFSLAM"]
        self.assertEqual(ini.getfloat("std_sensor_range"), 0.01)
        self.assertEqual(ini.getfloat("std_sensor_yaw_deg"), 0.2)


class Growth(unittest.TestCase):
    TEXT = """| landmarks | steps | step, mean [ms] | median [ms] | 99 % [ms] | worst [ms] | error [m] | NEES |
|---|---|---|---|---|---|---|---|
| 1000 | 5530 | 2.000 | 1.000 | 12.0 | 27.45 | 1.286 | 1.57 |
| 10000 | 6780 | 3.000 | 1.100 | 20.0 | 331.02 | 0.502 | 1.51 |
| 11000 | 50 | 9.000 | 9.000 | 4.2 | 22.12 | 0.440 | 0.69 |
"""

    def test_the_whole_map_is_compared_with_a_tenth_of_it(self):
        found = growth.rows(self.TEXT, 10000)
        self.assertEqual([row[:2] for row in found], [[1000, 5530], [10000, 6780]])
        text = growth.remark(found)
        self.assertIn("From 1000 to 10000 landmarks the mean step takes 1.50 times as long", text)
        self.assertIn("MISSED", text)
        self.assertIn("the median 1.10 times", text)

    def test_a_program_that_prints_no_table_is_an_error(self):
        with self.assertRaisesRegex(BenchError, "no two sizes"):
            growth.rows("killed", 10000)


class Consistency(unittest.TestCase):

    def test_bounds_narrow_around_3_with_the_seeds(self):
        low, high = consistency.bounds(50)
        self.assertAlmostEqual(low, 2.3597, places=3)   # chi2.ppf(0.025, 150) / 50
        self.assertAlmostEqual(high, 3.7160, places=3)  # chi2.ppf(0.975, 150) / 50

    def test_the_first_steps_do_not_count(self):
        values = [100.0] * consistency.FIRST_STEP + [3.0, 3.0, 3.0, 9.0]
        inside, mean = consistency.summary({"seeds": 50, "average_nees": values})
        self.assertEqual((inside, mean), (0.75, 4.5))

    def test_a_nees_that_is_not_finite_is_an_error(self):
        values = [3.0] * 30 + [float("nan")]
        with self.assertRaisesRegex(BenchError, "finite"):
            consistency.summary({"seeds": 50, "average_nees": values})

    def test_each_filter_goes_with_each_linearisation(self):
        variants = consistency.variants()
        self.assertEqual(len(variants), 8)
        self.assertEqual(variants[0], (consistency.DEFAULT, "extended", consistency.DEFAULT))
        self.assertIn(("unscented, textbook", "unscented", "textbook"), variants)

    def test_the_default_is_held_to_its_goals(self):
        good = {"seeds": 50, "average_nees": [3.0] * 100, "nis_mean": 1.0}
        self.assertEqual(consistency.remark(60, good).count("reached"), 2)
        bad = {"seeds": 50, "average_nees": [9.0] * 100, "nis_mean": 1.2}
        self.assertEqual(consistency.remark(60, bad).count("MISSED"), 2)

    def test_the_sparse_filter_is_judged_by_its_nees(self):
        values = [3.0] * (consistency.FIRST_STEP + 4)
        self.assertIn("3.00 (<= 3.6: reached)",
                      consistency.sparse_remark(60, {"seeds": 50, "average_nees": values}))
        values = [3.7] * (consistency.FIRST_STEP + 4)
        self.assertIn("MISSED", consistency.sparse_remark(60, {"seeds": 50, "average_nees": values}))

    def test_the_unscented_filter_is_judged_by_its_bounds_and_its_time(self):
        values = [3.0] * (consistency.FIRST_STEP + 4)
        extended = {"seeds": 50, "average_nees": values, "step_ms": 0.01}
        text = consistency.unscented_remark(120, extended, {**extended, "step_ms": 0.02})
        self.assertIn("step 2.00 times", text)
        self.assertEqual(text.count("reached"), 2)
        slow = {**extended, "step_ms": 0.04, "average_nees": [9.0] * len(values)}
        self.assertEqual(consistency.unscented_remark(120, extended, slow).count("MISSED"), 2)


class Landmarks(unittest.TestCase):

    def test_a_line_holds_ratio_and_goal(self):
        size = landmarks.Size(300, result(0.5, 0.004), result(8.0, 0.005))
        cells = dict(zip(landmarks.COST, landmarks.cost_row(size)))
        self.assertEqual((cells["ratio"], cells["goal"]), ("16.0", ">= 15: reached"))

    def test_errors_are_in_millimetres_ours_first(self):
        size = landmarks.Size(300, result(0.5, 0.004), result(8.0, 0.005))
        self.assertEqual(landmarks.accuracy_row(size),
                         ["300", "4.000", "5.000", "2.000", "2.500"])

    def test_a_size_without_a_goal_gets_no_verdict(self):
        size = landmarks.Size(100, result(0.5, 0.004), result(8.0, 0.005))
        self.assertEqual(landmarks.cost_row(size)[5], "-")

    def test_without_kf_slam_its_columns_are_left_out(self):
        size = landmarks.Size(300, result(0.5, 0.004), None)
        header, _ = table.drop_empty(landmarks.COST, [landmarks.cost_row(size)])
        self.assertEqual(header, ["landmarks", "seen", "ours CPU [s]", "ours memory [MB]"])
        header, _ = table.drop_empty(landmarks.ACCURACY,
                                           [landmarks.accuracy_row(size)])
        self.assertEqual(header, ["landmarks", "ours [mm]", "ours, aligned [mm]"])


class Update(unittest.TestCase):

    def test_sizes_are_taken_from_the_list_of_benchmarks(self):
        names = "ekf/landmarks:1000/observations:1\nekf/landmarks:100/observations:1\nother\n"
        self.assertEqual(update.parse_sizes(names), [100, 1000])

    def test_times_are_in_milliseconds_whatever_the_unit(self):
        entries = [{"name": f"ekf/landmarks:100/observations:{n}", "cpu_time": t, "time_unit": u}
                   for n, t, u in ((1, 2.0, "ms"), (10, 500.0, "us"))]
        self.assertEqual(update.parse_times(json.dumps({"benchmarks": entries})),
                         {"1 observation": 2.0, "10 observations": 0.5})

    def test_the_unscented_filter_has_its_own_columns(self):
        entries = [{"name": f"{name}/landmarks:100/observations:10", "cpu_time": t,
                    "time_unit": "ms"} for name, t in (("updateOfEkf", 1.0),
                                                       ("updateOfUnscentedFilter", 1.5))]
        self.assertEqual(update.parse_times(json.dumps({"benchmarks": entries})),
                         {"10 observations": 1.0, "10 observations, unscented": 1.5})

    def test_what_costs_the_whole_map_has_its_own_columns(self):
        entries = [{"name": f"{name}/landmarks:100/iterations:3", "cpu_time": 2.0,
                    "time_unit": "ms"} for name in ("globalUpdateOfEkf", "marginalsOfEkf")]
        self.assertEqual(update.parse_times(json.dumps({"benchmarks": entries})),
                         {"global update": 2.0, "all marginals": 2.0})

    def test_other_output_is_an_error(self):
        for text in ("", "{}", "[1]", "Run on (2 X 2000 MHz CPUs)"):
            with self.subTest(text), self.assertRaises(BenchError):
                update.parse_times(text)

    def test_a_time_that_was_not_measured_is_a_dash(self):
        sizes = [update.Size(100, {"1 observation": 0.25, "global update": 1.0}, 10.0),
                 update.Size(300, {"1 observation": 0.5}, 12.0)]
        self.assertEqual(update.rows(sizes)[1], [["100", "0.250", "1.000", "10.0"],
                                                       ["300", "0.500", "-", "12.0"]])


if __name__ == "__main__":
    unittest.main()
