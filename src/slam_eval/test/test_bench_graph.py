# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Graphs, tables and pictures of the benchmark graph."""
import contextlib
import io
import json
import pathlib
import tempfile
import types
import unittest
from unittest import mock

from slam_eval.bench import command_line
from slam_eval.bench.cli import BENCHMARKS
from slam_eval.bench.graph import false_loops, figures, files, solve, worlds
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.progress import Progress
from slam_eval.bench.harness.runs import Context


def report(name="a", ratio=1.0002, **changes):
    """What the program prints of a small graph."""
    batch = {"chi2": 10.0, "cpu_s": 0.01, "iterations": 3, "has_converged": True}
    made = {"name": name, "poses": 3, "edges": 3, "loops": 1, "false_loops": 1, "left_out": {},
            "cpu_s": 0.002, "mean_ms": 0.7, "p99_ms": 1.0, "worst_ms": 1.0, "memory_mb": 9.0,
            "chi2": 10.0 * ratio, "chi2_ratio": ratio, "ceres": dict(batch, chi2=10.5),
            "ceres_from_result": batch, "error_m": 0.1, "ceres_error_m": 0.1,
            "dead_reckoning_error_m": 2.0, "trajectory": [[0, 0, 0], [1, 0, 0], [1, 1, 1.6]],
            "loop_edges": [[0, 2, True]], "steps_ms": [0.1, 1.0, 1.0],
            "truth": [[0, 0], [1, 0], [1, 1]]}
    return {**made, **changes}


def robust_report(**changes):
    """What the program prints of a graph whose loops may be false."""
    return {"name": "a", "error_m": 1.0, "loops": 20, "false_loops": 10, "true_loops_rejected": 3,
            "false_loops_believed": 2, "cpu_s": 0.5, **changes}


class Folder(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.calls = []

    def context(self, **options):
        """A benchmark whose files are in this folder."""
        return Context(self.folder, self.folder, Progress(io.StringIO()),
                       types.SimpleNamespace(**options))

    def solve(self, _, name, arguments, __):
        """Instead of the program."""
        self.calls.append([getattr(word, "name", word) for word in arguments])
        if name == "bad":
            raise BenchError("slam_eval_graph ended with exit code 1: bad.g2o:1: nan")
        return report(name)


class Files(Folder):

    def measure(self, *names):
        """The section for g2o files of these names."""
        graphs = self.folder / "graphs"
        graphs.mkdir()
        for name in names:
            (graphs / name).touch()
        with mock.patch.object(files, "solve", self.solve):
            return files.measure(self.context(graphs=graphs))

    def test_each_graph_is_solved_and_held_against_its_truth(self):
        section = self.measure("b.g2o", "a.g2o", "a_truth.txt", "b_truth.dat", "c.g2o", "d.txt")
        self.assertEqual(self.calls, [["--g2o", "a.g2o", "--truth", "a_truth.txt"],
                                      ["--g2o", "b.g2o", "--truth", "b_truth.dat"],
                                      ["--g2o", "c.g2o"]])
        self.assertEqual(section.failures, [])
        self.assertEqual(len(section.pictures), 3)
        self.assertTrue(all(path.is_file() for path in section.pictures.values()))

    def test_a_graph_that_cannot_be_read_is_reported_and_the_others_are_solved(self):
        section = self.measure("a.g2o", "bad.g2o", "c.g2o")
        self.assertEqual(section.failures, [
            "bad: slam_eval_graph ended with exit code 1: bad.g2o:1: nan"])
        self.assertIn("| c ", section.markdown())

    def test_without_graphs_it_says_where_it_looked(self):
        section = self.measure()
        self.assertIn(f"there is no g2o file in {self.folder / 'graphs'}", section.markdown())
        self.assertEqual(section.failures, [])

    def test_graphs_are_looked_for_among_the_shared_data(self):
        (self.folder / "graphs").mkdir()
        (self.folder / "graphs" / "a.g2o").touch()
        with mock.patch.object(files, "solve", self.solve), \
                mock.patch.dict("os.environ", {"SLAM_DATA_DIR": str(self.folder)}):
            files.measure(self.context(graphs=None))
        self.assertEqual(self.calls, [["--g2o", "a.g2o"]])


class Worlds(Folder):

    def test_a_city_of_each_size_is_driven_through(self):
        with mock.patch.object(worlds, "solve", self.solve):
            section = worlds.measure(self.context(poses=(100, 300), seed=4))
        self.assertEqual(self.calls, [["--world", 4, "--poses", 100],
                                      ["--world", 4, "--poses", 300]])
        self.assertIn("| world_4_300 ", section.markdown())
        self.assertEqual(sorted(path.name for path in section.pictures.values()),
                         ["graph_world_4_100.png", "graph_world_4_300.png"])

    def test_the_program_prints_what_is_read_here(self):
        try:
            workspace_program("slam_eval", solve.PROGRAM)
        except BenchError as error:
            self.skipTest(str(error))
        section = worlds.measure(self.context(poses=(60,), seed=1))
        self.assertIn("| world_1_60 |    60 |", section.markdown())
        self.assertIn("<= 0.1: reached", section.markdown())


class FalseLoops(Folder):

    ERRORS = {"clean": 1.0, "local_groups_2": 1.2}

    def solve_robust(self, _, name, arguments, label):
        """Instead of the program."""
        self.calls.append([getattr(word, "name", word) for word in arguments])
        self.labels.append(label)
        return robust_report(error_m=self.ERRORS.get(name, 1.01), name=name)

    def measure(self, *names):
        """The section for files of these names among the graphs."""
        self.labels = []
        for name in names:
            (self.folder / name).touch()
        with mock.patch.object(false_loops, "solve", self.solve_robust):
            return false_loops.measure(self.context(graphs=self.folder, seed=4, seeds=2))

    def test_each_kind_is_run_with_each_seed_beside_the_clean_graph_and_the_ring(self):
        graph = ["--g2o", "manhattan3500.g2o", "--truth", "manhattan3500_truth.dat"]
        section = self.measure("manhattan3500.g2o", "manhattan3500_truth.dat", "ring.g2o",
                               "ring_truth.txt")
        self.assertEqual(self.calls[0], graph)
        self.assertEqual(self.calls[2], [*graph, "--false-loops", 1000, "--kind", "random",
                                         "--seed", 2])
        self.assertEqual(self.calls[-1], ["--g2o", "ring.g2o", "--truth", "ring_truth.txt"])
        self.assertEqual(len(self.calls), 1 + 4 * 2 + 1)
        self.assertIn("run 3 of 10", self.labels[2])
        self.assertEqual(section.title, "False loops in manhattan3500")

    def test_without_the_graph_it_is_a_city_and_the_ring_is_left_out(self):
        section = self.measure("manhattan3500.g2o")  # without its truth
        self.assertEqual(self.calls[0], ["--world", 4, "--poses", 3500])
        self.assertEqual(len(self.calls), 1 + 4 * 2)
        self.assertIn("simulated city", section.title)
        self.assertIn("ring is left out", section.markdown())

    def test_a_run_that_false_loops_have_bent_is_counted(self):
        text = self.measure().markdown()
        self.assertIn("runs within 1.05 times the clean error 7 (>= 8: MISSED)", text)
        lines = {line.split("|")[1].strip(): [cell.strip() for cell in line.split("|")[2:-1]]
                 for line in text.splitlines() if line.startswith("|")}
        self.assertEqual(lines["local_groups"],
                         ["2", "1.105", "1.200", "1.200", "1", "4", "6", "0.50"])

    def test_a_ring_that_loses_true_loops_is_no_success(self):
        names = ("ring.g2o", "ring_truth.txt")
        self.assertIn("true ones that wait 3 (<= 0: MISSED)", self.measure(*names).markdown())

    def test_other_output_is_an_error(self):
        self.assertEqual(false_loops.parse_report(json.dumps(robust_report())), robust_report())
        for text in ("", "[]", "{}", json.dumps(robust_report(error_m=None))):
            with self.subTest(text), self.assertRaisesRegex(BenchError, "no JSON of a robust run"):
                false_loops.parse_report(text)

    def test_the_program_prints_what_is_read_here(self):
        try:
            workspace_program("slam_eval", solve.PROGRAM)
        except BenchError as error:
            self.skipTest(str(error))
        made = false_loops.solve(self.context(), "a", ["--world", 1, "--poses", 100], "a city")
        self.assertEqual((made["false_loops"], made["false_loops_believed"]), (0, 0))


class Figures(unittest.TestCase):

    def test_a_line_holds_the_lower_chi2_of_ceres(self):
        line = dict(zip(figures.HEADER, figures.row(report())))
        self.assertEqual((line["Ceres chi2"], line["ratio"], line["odometry [m]"]),
                         (10.0, 1.0002, 2.0))

    def test_chi2_is_held_to_that_of_ceres_in_the_worst_graph(self):
        good, bad = figures.row(report()), figures.row(report(ratio=1.002))
        self.assertIn("worst: 0.020 % (<= 0.1: reached)", figures.goal_line([good]))
        self.assertIn("worst: 0.200 % (<= 0.1: MISSED)", figures.goal_line([good, bad]))

    def test_columns_without_a_value_are_left_out(self):
        bare = report()
        for key in ("chi2_ratio", "error_m", "ceres_error_m", "dead_reckoning_error_m"):
            del bare[key]
        text = figures.describe([bare])[0]
        self.assertNotIn("error", text)
        self.assertNotIn("ratio", text)
        self.assertEqual(figures.goal_line([figures.row(bare)]), "")

    def test_what_was_left_out_and_what_has_not_converged_is_reported(self):
        odd = report(left_out={"FIX": 2}, ceres=dict(report()["ceres"], has_converged=False))
        self.assertIn("- a: records of type FIX are not used (2).\n- a: Ceres has not converged",
                      "\n".join(figures.describe([odd])))
        self.assertEqual(figures.notes(report()), [])


class Program(Folder):

    def test_other_output_is_an_error(self):
        self.assertEqual(solve.parse_report(json.dumps(report())), report())
        short = report(steps_ms=[0.1])
        for text in ("", "[]", "{}", json.dumps(short), json.dumps(report(chi2=None))):
            with self.subTest(text), self.assertRaisesRegex(BenchError, "printed no JSON"):
                solve.parse_report(text)

    def test_the_last_line_of_its_log_says_how_far_it_is(self):
        log = self.folder / "log"
        self.assertEqual(solve.last_line(log), "")
        log.write_text("")
        self.assertEqual(solve.last_line(log), "")
        log.write_text("poses: 10 %\nposes: 40 %\n")
        self.assertEqual(solve.last_line(log), "poses: 40 %")


class Options(unittest.TestCase):

    def parse(self, *arguments):
        """The options of a call."""
        return command_line.parse(["graph", *arguments], BENCHMARKS)

    def test_parts_sizes_and_folders(self):
        self.assertEqual(self.parse().only, ["worlds", "files", "false_loops"])
        self.assertEqual(self.parse("--poses", "300,100").poses, (100, 300))
        self.assertIsNone(self.parse().graphs)
        for arguments in (["--graphs", "no/such/folder"], ["--poses", "0"], ["--only", "odd"]):
            with self.subTest(arguments), contextlib.redirect_stderr(io.StringIO()), \
                    self.assertRaises(SystemExit):
                self.parse(*arguments)


if __name__ == "__main__":
    unittest.main()
