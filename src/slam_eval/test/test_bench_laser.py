# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Logs, tables and figures of the benchmark laser, without running any product."""
import contextlib
import io
import json
import pathlib
import tempfile
import types
import unittest
from unittest import mock

import numpy as np

from slam_eval.bench import command_line
from slam_eval.bench.cli import BENCHMARKS
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.process import Usage
from slam_eval.bench.harness.products import makes_a_grid
from slam_eval.bench.laser import figures, log, logs, odometry
from slam_eval.bench.peers import bag_rawlog
from slam_eval.io.errors import InputError
from slam_eval.io.relations import Relations, SourceStamps
from slam_eval.io.trajectory import NANOSECONDS, Trajectory

STEPS = 5


def path(noise=0.0):
    """A straight way, a metre and a second for each pose."""
    poses = np.zeros((STEPS, 3))
    poses[:, 0] = np.arange(STEPS)
    poses[:, 1] = noise * np.arange(STEPS) ** 2
    return Trajectory(NANOSECONDS * np.arange(1, STEPS + 1), poses)


def relations(pairs=((0, 1), (1, 2), (0, 4))):
    """True relations between poses of that way."""
    pairs = np.array(pairs)
    deltas = np.column_stack([pairs[:, 1] - pairs[:, 0], 0 * pairs[:, 0], 0 * pairs[:, 0]])
    return Relations(NANOSECONDS * (pairs + 1), deltas.astype(float))


def make_log(folder, name="a", of=relations()):
    """A log that is a bag."""
    return log.Log(name, folder / f"{name}.bag", False, of, None)


class Bench:
    """The part logs in a folder of its own; what a run gives is told by product and seed."""

    def __init__(self, test, runs, products=("scan", "pf"), seeds=3):
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self.folder, self.runs, self.calls = pathlib.Path(folder.name), runs, []
        options = types.SimpleNamespace(products=list(products), seeds=seeds, robot=None, keep=None,
                                        logs=[], tolerance=0.2)
        self.context = types.SimpleNamespace(out=self.folder, work=self.folder, options=options)

    def run_ours(self, context, name, bag, product=None, settings=(), **_):
        """Instead of running a product."""
        self.calls.append((product, settings[0]))
        made = self.runs(product, int(settings[0].partition("=")[2]))
        return types.SimpleNamespace(final=made, trajectory=made, odometry=None, grid=None,
                                     path=name), Usage(1.0, 2.0, 30.0)

    def measure(self, *names):
        """The sections for logs of these names."""
        self.context.options.logs = [self.folder / name for name in names]
        for given in self.context.options.logs:
            given.touch()
        with mock.patch.object(logs, "run_ours", self.run_ours), \
                mock.patch.object(logs, "read_run", lambda run: run), \
                mock.patch.object(logs, "make_rawlog", side_effect=BenchError("no odometry")):
            return list(logs.measure(self.context))


class Logs(unittest.TestCase):

    def bench(self, runs=lambda product, seed: path(0.001 * seed if product == "pf" else 0.0)):
        """A bench whose product scan does not depend on the seed, and whose pf does."""
        return Bench(self, runs)

    def test_only_a_product_that_draws_random_numbers_runs_with_all_seeds(self):
        bench = self.bench()
        sections = bench.measure("a.bag", "b.bag")
        pf = [("pf", f"seed={seed}") for seed in (1, 2, 3)]
        self.assertEqual(bench.calls, [("scan", "seed=1"), ("scan", "seed=2"), *pf,
                                       ("scan", "seed=1"), *pf])
        self.assertEqual([section.title for section in sections], ["a", "b", "All logs"])
        self.assertEqual([section.failures for section in sections], [[], [], []])
        self.assertTrue(all(p.is_file() for s in sections[:2] for p in s.pictures.values()))

    def test_a_log_without_relations_gets_no_errors_and_says_so(self):
        text = self.bench().measure("a.bag")[0].markdown()
        self.assertIn("No relations stand beside this log", text)
        self.assertIn("| product | seed | CPU [s] | memory [MB] |", text)
        self.assertIn("rbpf-slam is left out: no odometry.", text)

    def test_what_fails_is_told_and_the_rest_is_measured(self):
        def runs(product, seed):
            if product == "scan":
                raise BenchError("it ended with exit code 1")
            return path(0.001 * seed)

        first, second, third, _ = self.bench(runs).measure("a.bag", "b.txt", "c.bag")
        self.assertEqual(first.failures, ["scan: it ended with exit code 1"])
        self.assertIn("Failed: scan: it ended with exit code 1", first.markdown())
        self.assertRegex(second.failures[0], "b.txt is no log that is known here")
        self.assertEqual([s.markdown().count("| pf ") for s in (first, third)], [3, 3])

    def test_bad_relations_are_told_before_anything_runs(self):
        bench = self.bench()
        (bench.folder / "a.relations").write_text("1 2 3\n")
        section = bench.measure("a.bag")[0]
        self.assertEqual((len(section.failures), bench.calls), (1, []))
        self.assertIn("a.relations:1: 3 fields where", section.failures[0])

    def test_without_a_log_it_says_where_it_looked(self):
        bench = self.bench()
        with mock.patch.object(logs, "default_logs", list):
            self.assertIn("no log was given", bench.measure()[0].paragraphs[0])

    def test_logs_of_one_name_are_told_apart(self):
        self.assertEqual(log.names_of([pathlib.Path("x/a.clf"), pathlib.Path("y/a.clf"),
                                       pathlib.Path("b.clf")]), ["a", "a_2", "b"])

    def test_a_stamp_may_be_off_by_the_tolerance(self):
        late = relations()
        late.stamps = late.stamps + NANOSECONDS // 10
        given = make_log(pathlib.Path(), of=late)
        self.assertEqual(given.judge(path(), None, 0.2).metrics["relations"], 3)
        self.assertIsNone(given.judge(path(), None, 0.05))


class Figures(unittest.TestCase):

    def line(self, product="pf_wheel_grid", seed=1, noise=0.001, of=relations(), scans=None):
        """The numbers of a run, by their columns."""
        stamps = SourceStamps(path().stamps, path().stamps, scans)
        given = log.Log("a", pathlib.Path("a.bag"), False, of, stamps)
        return figures.row(product, seed, given.judge(path(noise), None, 0.01),
                           Usage(1.0, 2.0, 30.0))

    def test_revisits_and_unambiguous_relations_stand_apart_where_they_are_a_part(self):
        row = dict(zip(figures.HEADER, self.line()))
        self.assertEqual((row["relations"], row["revisits"], row["unambiguous"]), (3, 1, None))
        self.assertGreater(row["r. [m]"], row["[m]"])
        row = dict(zip(figures.HEADER, self.line(scans=np.array([1, 1, 2, 1, 1]))))
        self.assertEqual(row["unambiguous"], 2)
        row = dict(zip(figures.HEADER, self.line(of=relations([(0, 1), (1, 2)]))))
        self.assertEqual(row["revisits"], None)

    def test_each_seed_is_held_to_the_goals_of_its_log(self):
        good, bad = self.line(), self.line(seed=2, noise=0.1)
        self.assertIn("reached", figures.judged("key-x", [good]))
        self.assertIn("pf_wheel_grid: worst r. [m]", figures.judged("key-x", [good, bad]))
        self.assertIn("MISSED", figures.judged("key-x", [good, bad]))
        self.assertEqual(figures.judged("other", [bad]), "")
        self.assertEqual(figures.judged("key-x", [self.line("scan_grid")]), "")

    def test_the_overview_tells_the_worst_seed(self):
        rows = {"a": [self.line(), self.line(seed=2, noise=0.01)], "b": [self.line()]}
        worst = rows["a"][1][figures.HEADER.index("[m]")]
        self.assertIn(f"{worst:.3f}", figures.overview(rows)[0])
        self.assertEqual(figures.overview({"a": rows["a"]}), [])


class Peer(unittest.TestCase):

    def test_frames_are_a_part_of_the_scans(self):
        odometry_, is_frame = bag_rawlog.parse_scans("1 0 0 0 1\n2 0.1 0 0 0\n3 0.3 0 0.1 1\n")
        self.assertEqual(list(odometry_.stamps), [1, 2, 3])
        self.assertEqual(list(is_frame), [True, False, True])

    def test_a_path_has_a_pose_for_each_frame_after_the_start(self):
        rawlog = bag_rawlog.BagRawlog(None, path(), np.array([True, False, True, False, False]))
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "most_likely_path.txt").write_text("0 0 0\n1 2 0.5\n3 4 0.6\n")
            read = bag_rawlog.read_path(folder, rawlog)
            self.assertEqual(list(read.stamps), [NANOSECONDS, 3 * NANOSECONDS])
            self.assertEqual(list(read.poses[1]), [3.0, 4.0, 0.6])
            for text in ("0 0 0\n1 2 0.5\n", "", "0 0\n1 2\n1 2\n", "x\n"):
                (folder / "most_likely_path.txt").write_text(text)
                with self.subTest(text), self.assertRaisesRegex(BenchError, "of another version"), \
                        contextlib.redirect_stderr(io.StringIO()):
                    bag_rawlog.read_path(folder, rawlog)


class Odometry(unittest.TestCase):

    def test_times_and_drift_of_each_odometry(self):
        entry = {"name": "laser", "ms_mean": 0.2, "ms_p99": 0.6, "ms_max": 0.8, "nees": 3.0,
                 "translation": 0.002, "rotation_rad_per_m": 0.001}
        short = {key: entry[key] for key in ("name", "ms_mean", "ms_p99", "ms_max")}
        text = json.dumps({"world": "office", "scans": 9, "odometry": [entry, short]})
        first, second = odometry.rows_of(odometry.parse_result(text), 1)
        self.assertAlmostEqual(first[odometry.HEADER.index("drift [%]")], 0.2)
        self.assertAlmostEqual(first[odometry.HEADER.index("heading [deg/m]")], 0.0573, places=4)
        self.assertEqual(second[-3:], [None, None, None])
        for bad in ("", "{}", json.dumps({"scans": 9, "odometry": [{"name": "laser"}]})):
            with self.subTest(bad), self.assertRaisesRegex(BenchError, "printed no JSON"):
                odometry.parse_result(bad)


class Options(unittest.TestCase):

    def parse(self, *arguments):
        """The options of a call."""
        return command_line.parse(["laser", *arguments], BENCHMARKS)

    def test_logs_are_files_that_exist(self):
        self.assertEqual(self.parse(__file__).logs, [pathlib.Path(__file__).absolute()])
        self.assertEqual((self.parse().logs, self.parse().tolerance), ([], 0.2))
        for arguments in (["none.clf"], ["--tolerance", "-1"], ["--tolerance", "nan"],
                          ["--seeds", "0"]):
            with self.subTest(arguments), contextlib.redirect_stderr(io.StringIO()), \
                    self.assertRaises(SystemExit):
                self.parse(*arguments)

    def test_products_are_those_that_make_a_grid_of_a_log(self):
        self.assertTrue(makes_a_grid({"map": "grid", "odometry": "none"}))
        for features in ({"map": "landmarks", "odometry": "wheel"}, {},
                         {"map": "grid", "odometry": "visual"},
                         {"map": "grid", "odometry": "wheel", "detector": "aruco"}):
            self.assertFalse(makes_a_grid(features), features)

    def test_an_error_in_a_file_is_told_with_its_place(self):
        with tempfile.TemporaryDirectory() as name:
            bag = pathlib.Path(name) / "a.bag"
            bag.with_suffix(".relations").write_text("# none\n")
            with self.assertRaisesRegex(InputError, "a.relations: holds no relation"):
                log.open_log(None, "a", bag)


if __name__ == "__main__":
    unittest.main()
