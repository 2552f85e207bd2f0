# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the benchmark kills finds different in a run's files, and that it kills, resumes and
compares."""
import json
import pathlib
import tempfile
import types
import unittest

from slam_eval.bench import kills
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.hall_drives import Drives, LANDMARKS
from slam_eval.bench.harness.progress import Progress
from slam_eval.bench.harness.runs import Context


class InFolder(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_of(self, name, path="1 2 3\n", **figures):
        """A run's folder."""
        folder = self.folder / name
        folder.mkdir()
        (folder / "trajectory.tum").write_text(path, encoding="utf-8")
        (folder / "config.yaml").write_text("version: 1\n", encoding="utf-8")
        (folder / "metrics.json").write_text(json.dumps({"steps": 3, **figures}), encoding="utf-8")
        return folder


class Difference(InFolder):

    def test_times_and_memory_are_none(self):
        run = self.run_of("a", cpu_s=1.0, step_p99_ms=2.0, max_rss_mb=3.0)
        self.assertEqual(kills.difference(run, self.run_of("b", cpu_s=2.0, step_p99_ms=3.0)), "")

    def test_a_byte_is_one(self):
        run = self.run_of("a", path="1 2 4\n")
        self.assertEqual(kills.difference(run, self.run_of("b")), "trajectory.tum differs")

    def test_a_missing_file_and_another_figure_are_ones(self):
        whole, run = self.run_of("a"), self.run_of("b", steps=4)
        self.assertIn("differs: steps", kills.difference(run, whole))
        (run / "trajectory.tum").unlink()
        self.assertIn("instead of", kills.difference(run, whole))

    def test_one_misses_the_goal(self):
        tally = kills.Tally(same=2, faults=["trajectory.tum differs"])
        line, is_reached = kills.row_of("x", tally)
        self.assertFalse(is_reached)
        self.assertEqual(line[-4:], ["3", "2", "0", "MISSED"])


class State(InFolder):

    def test_a_run_with_a_checkpoint_is_not_complete(self):
        run = self.run_of("a")
        self.assertTrue(kills.is_complete(run))
        (run / "unfinished_run").mkdir()
        (run / "unfinished_run/checkpoint").touch()
        self.assertFalse(kills.is_complete(run))


class Runs(InFolder):

    def context(self, **options):
        return Context(self.folder, self.folder, Progress(), types.SimpleNamespace(
            **{"bag": None, "products": ["ekf_wheel"], "seed": 3, "kills": 3, **options}))

    def test_are_killed_so_often_and_end_with_the_same_bytes(self):
        section = kills.measure(self.context())
        self.assertEqual(section.failures, [])
        self.assertRegex(section.paragraphs[0], r"\| ekf_wheel +\| +3 \|.*reached \|")

    def test_of_a_product_that_cannot_be_run_are_a_failure_that_says_why(self):
        section = kills.measure(self.context(products=["ekf_wheels"]))
        self.assertEqual(len(section.failures), 1)
        self.assertIn("ekf_wheels", section.failures[0])

    def test_that_end_by_themselves_with_an_error_are_a_failure(self):
        context = self.context()
        bag = Drives(context).bag(3, LANDMARKS)
        runs = kills.KilledRuns(context, "ekf_wheel", bag)
        bag.unlink()
        with self.assertRaisesRegex(BenchError, f"ekf_wheel ended with .*{bag.name}"):
            runs.kill(1)


if __name__ == "__main__":
    unittest.main()
