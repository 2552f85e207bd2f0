# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program slam_eval from end to end."""
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.report.cli import main  # noqa: E402


class SlamEval(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.run_folder = pathlib.Path(folder.name) / "run"

    def evaluate(self, *arguments):
        """Run the program's main function; what it printed and its exit code."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = main([str(argument) for argument in arguments])
            except SystemExit as wrong_use:
                code = wrong_use.code
        return subprocess.CompletedProcess(arguments, code, out.getvalue(), err.getvalue())

    def evaluate_as_user(self, *arguments):
        """Run the installed script."""
        environment = {**os.environ, "PYTHONPATH": str(run_maker.PACKAGE / "src")}
        environment.pop("DISPLAY", None)
        return subprocess.run([sys.executable, run_maker.PACKAGE / "scripts" / "slam_eval",
                               *arguments], env=environment, capture_output=True, text=True,
                              check=False)

    def fails(self, *parts):
        """The evaluation ends with one sentence that holds the parts, exit code 1, no traceback."""
        done = self.evaluate(self.run_folder)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)

    def names(self):
        """Names of the files in the run folder."""
        return {path.name for path in self.run_folder.iterdir()}

    def test_shows_the_graph_and_what_happened(self):
        run_maker.make_run(self.run_folder, count=60)
        (self.run_folder / "graph.csv").write_text(run_maker.GRAPH)
        (self.run_folder / "events.csv").write_text(run_maker.EVENTS)
        done = self.evaluate(self.run_folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.run_folder / "graph.png").read_bytes()[:4], b"\x89PNG")
        report = (self.run_folder / "report.html").read_text()
        self.assertIn("Graph of poses", report)
        self.assertIn("loop closed", report)
        self.assertIn("the robot was put there", report)

    def test_draws_no_graph_where_there_is_none(self):
        run_maker.make_run(self.run_folder, count=60)
        (self.run_folder / "graph.csv").write_text(run_maker.GRAPH.splitlines()[0] + "\n")
        self.assertEqual(self.evaluate(self.run_folder).returncode, 0)
        self.assertNotIn("graph.png", self.names())

    def test_adds_figures_pictures_and_report(self):
        run_maker.make_run(self.run_folder, count=300)
        done = self.evaluate_as_user(self.run_folder, "--reference-title", "Vicon")
        self.assertEqual(done.returncode, 0, done.stderr)
        metrics = json.loads((self.run_folder / "metrics.json").read_text())
        for key in ("ate_rmse_m", "ate_max_m", "odometry_ate_rmse_m", "landmark_rmse_m",
                    "nees_mean", "nis_mean"):
            self.assertGreater(metrics[key], 0.0, key)
        self.assertEqual(metrics["landmarks"], 18)
        self.assertEqual(metrics["cpu_s"], 0.8)
        self.assertLess(metrics["ate_rmse_m"], 0.15)
        for name in ("map.png", "trajectory.png", "landmark_errors.png", "consistency.png",
                     "seen.png"):
            self.assertEqual((self.run_folder / name).read_bytes()[:4], b"\x89PNG")
        self.assertIn("Absolute trajectory error", done.stdout)
        self.assertFalse([n for n in self.names() if n.startswith(".")])

    def test_report_stands_alone(self):
        run_maker.make_run(self.run_folder, count=300)
        self.evaluate(self.run_folder)
        report = (self.run_folder / "report.html").read_text()
        self.assertEqual(report.count('src="data:image/png;base64,'), 5)
        self.assertNotIn("http", report)
        self.assertIn("gate_probability: 0.99", report)
        self.assertIn("3 is expected", report)
        self.assertIn('Steps with landmarks</td><td class="v">', report)

    def test_the_report_tells_what_became_of_the_features_in_the_images(self):
        run_maker.make_run(self.run_folder, count=60)
        (self.run_folder / "views.csv").write_text(
            "stamp,features,expected,matched,rejected\n1000.1,300,40,35,2\n1000.2,290,42,36,4\n")
        self.assertEqual(self.evaluate(self.run_folder).returncode, 0)
        report = (self.run_folder / "report.html").read_text()
        for text in ('Images</td><td class="v">2<', 'Features</td><td class="v">590<',
                     'Matched</td><td class="v">71<', "35.5 an image", "What was seen"):
            self.assertIn(text, report)

    def test_names_the_line_of_views_that_is_damaged(self):
        run_maker.make_run(self.run_folder, count=60)
        views = self.run_folder / "views.csv"
        for line, what in (("1000.1,300", "cut off"), ("1000.1,300,40,x,2", "no number"),
                           ("1000.1,300,40,nan,2", "not finite"),
                           ("1000.1,300,40,-1,2", "no whole number"),
                           ("1000.1,1e300,40,35,2", "no whole number"),
                           ("1000.1,300,40.5,35,2", "no whole number")):
            views.write_text(f"stamp,features,expected,matched,rejected\n{line}\n")
            self.fails("views.csv:2:", what)
        views.write_text("stamp,features\n")
        self.fails("views.csv:1:", "run the product again")

    def test_the_report_names_bag_version_date_and_command(self):
        run_maker.make_run(self.run_folder, count=60)
        metrics = self.run_folder / "metrics.json"
        run = {"version": "0.1.0", "commit": "0123", "date": "2026-11-26 09:00:00 UTC",
               "command": "./slam run a --bag '<b>'",
               "bag": {"name": "b.bag", "bytes": 12_345_678, "sha256": "0123456789abcdef"}}
        metrics.write_text(json.dumps({"updates": 1, "run": run}), encoding="utf-8")
        self.assertEqual(self.evaluate(self.run_folder).returncode, 0)
        report = (self.run_folder / "report.html").read_text(encoding="utf-8")
        for text in ("b.bag, 12.3 MB, sha256 0123456789ab…", "0.1.0 (commit 0123)",
                     "2026-11-26 09:00:00 UTC", "./slam run a --bag &#x27;&lt;b&gt;&#x27;"):
            self.assertIn(text, report)
        self.assertEqual(json.loads(metrics.read_text(encoding="utf-8"))["run"], run)

    def test_wheels_that_the_run_did_not_use_are_drawn_beside_its_odometry(self):
        run_maker.make_run(self.run_folder, count=300)
        truth = (self.run_folder / "ground_truth.tum").read_text()
        (self.run_folder / "wheel_odometry.tum").write_text(truth)
        self.assertEqual(self.evaluate(self.run_folder).returncode, 0)
        metrics = json.loads((self.run_folder / "metrics.json").read_text())
        self.assertLess(metrics["wheel_odometry_ate_rmse_m"], 1e-6)
        self.assertLess(metrics["wheel_odometry_drift_percent"], 1e-3)
        self.assertEqual((self.run_folder / "odometry.png").read_bytes()[:4], b"\x89PNG")
        self.assertIn("figure 6.6b", (self.run_folder / "report.html").read_text())

    def test_draws_the_walls_of_the_world(self):
        run_maker.make_run(self.run_folder, count=300)
        self.evaluate(self.run_folder)
        bare = (self.run_folder / "map.png").read_bytes()
        world = self.run_folder / "world.yaml"
        world.write_text("walls:\n  - {points: [[0, 0], [4, 0], [4, 3]], closed: true}\n"
                         "furniture:\n  - {centre: [1, 1], size: [0.5, 0.4, 1.0], yaw: 0.3}\n")
        done = self.evaluate(self.run_folder, "--world", world)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual((self.run_folder / "map.png").read_bytes(), bare)

    def test_draws_the_labels_of_landmarks(self):
        run_maker.make_run(self.run_folder, count=60)
        self.evaluate(self.run_folder)
        bare = (self.run_folder / "map.png").read_bytes()
        (self.run_folder / "labels.yaml").write_text(
            "version: 1\nlandmarks:\n- {id: 7, label: door $1$ of $2}\n", encoding="utf-8")
        done = self.evaluate(self.run_folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual((self.run_folder / "map.png").read_bytes(), bare)
        (self.run_folder / "labels.yaml").write_text("version: 1\n", encoding="utf-8")
        self.fails("labels.yaml", "no labels as slam_labels saves them")

    def test_a_file_that_is_no_world_is_named(self):
        run_maker.make_run(self.run_folder, count=30)
        for text in ("just words\n", "walls:\n  - {from: [0, 0]}\n", "walls: [\n"):
            (self.run_folder / "world.yaml").write_text(text)
            done = self.evaluate(self.run_folder, "--world", self.run_folder / "world.yaml")
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn("world.yaml", done.stderr)

    def test_judges_a_run_in_the_map_that_another_run_has_made(self):
        made = self.run_folder.parent / "made"
        run_maker.make_run(made, count=60)
        run_maker.make_run(self.run_folder, count=60)
        path = self.run_folder / "trajectory.tum"
        rows = [line.split() for line in path.read_text().splitlines()]
        path.write_text("".join(" ".join([row[0], str(float(row[1]) + 10.0), *row[2:]]) + "\n"
                                for row in rows))
        errors = []
        for arguments in ((), ("--map-run", made)):
            self.assertEqual(self.evaluate(self.run_folder, *arguments).returncode, 0)
            metrics = json.loads((self.run_folder / "metrics.json").read_text())
            errors.append(metrics["ate_unaligned_rmse_m"])
        self.assertLess(errors[0], 1.0)
        self.assertAlmostEqual(errors[1], 10.0, delta=1.0)
        self.assertGreater(metrics["confidently_wrong_s"], 0.0)
        (made / "ground_truth.tum").unlink()
        done = self.evaluate(self.run_folder, "--map-run", made)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nobody knows where its map lies", done.stderr)

    def test_works_without_truth_and_says_what_is_missing(self):
        run_maker.make_run(self.run_folder, count=300, truth=False)
        done = self.evaluate(self.run_folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        metrics = json.loads((self.run_folder / "metrics.json").read_text())
        self.assertNotIn("ate_rmse_m", metrics)
        self.assertNotIn("nees_mean", metrics)
        self.assertGreater(metrics["nis_mean"], 0.5)
        self.assertIn("no ground truth", done.stdout)
        self.assertIn("no ground truth", (self.run_folder / "report.html").read_text())

    def test_works_with_a_trajectory_alone(self):
        run_maker.make_run(self.run_folder, count=300)
        for path in self.run_folder.iterdir():
            if path.name != "trajectory.tum":
                path.unlink()
        self.assertEqual(self.evaluate(self.run_folder).returncode, 0)
        self.assertEqual(self.names(),
                         {"trajectory.tum", "trajectory.png", "report.html", "metrics.json"})

    def test_works_with_a_single_pose_and_with_an_empty_map(self):
        run_maker.make_run(self.run_folder, count=300)
        for name in ("updates.csv", "odometry.tum", "trajectory.tum"):
            path = self.run_folder / name
            lines = path.read_text().splitlines(keepends=True)
            path.write_text("".join(lines[:2 if name == "updates.csv" else 1]))
        (self.run_folder / "landmarks.yaml").write_text("version: 1\nlandmarks: []\n")
        done = self.evaluate(self.run_folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")

    def test_a_second_evaluation_gives_the_same_figures(self):
        run_maker.make_run(self.run_folder, count=300)
        self.evaluate(self.run_folder)
        first = (self.run_folder / "metrics.json").read_text()
        self.evaluate(self.run_folder)
        self.assertEqual((self.run_folder / "metrics.json").read_text(), first)

    def test_a_figure_that_cannot_be_computed_any_more_does_not_survive(self):
        run_maker.make_run(self.run_folder, count=300)
        self.evaluate(self.run_folder)
        (self.run_folder / "ground_truth.tum").unlink()
        self.evaluate(self.run_folder)
        self.assertNotIn("ate_rmse_m", (self.run_folder / "metrics.json").read_text())

    def test_wrong_use_ends_with_code_2(self):
        self.assertEqual(self.evaluate().returncode, 2)
        run_maker.make_run(self.run_folder, count=30)
        self.assertEqual(self.evaluate(self.run_folder, "--nonsense", "x").returncode, 2)

    def test_a_missing_folder_is_named(self):
        self.fails(str(self.run_folder), "no such folder")

    def test_a_picture_that_cannot_be_written_is_named(self):
        run_maker.make_run(self.run_folder, count=30)
        (self.run_folder / "trajectory.png").mkdir()
        self.fails("trajectory.png", "cannot be written")
        self.assertFalse([n for n in self.names() if n.startswith(".")])

    def test_the_script_ends_with_one_sentence_for_a_bad_folder(self):
        done = self.evaluate_as_user(self.run_folder)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))

    def test_a_folder_without_trajectory_is_named(self):
        self.run_folder.mkdir()
        self.fails("trajectory.tum")

    def test_an_empty_trajectory_is_named(self):
        run_maker.make_run(self.run_folder, count=30)
        (self.run_folder / "trajectory.tum").write_text("")
        self.fails("trajectory.tum", "empty")

    def test_a_bad_file_leaves_the_metrics_untouched(self):
        run_maker.make_run(self.run_folder, count=30)
        before = (self.run_folder / "metrics.json").read_text()
        path = self.run_folder / "ground_truth.tum"
        path.write_text(path.read_text()[:-20])
        self.fails("ground_truth.tum:", "run the product again")
        self.assertEqual((self.run_folder / "metrics.json").read_text(), before)
        self.assertNotIn("report.html", self.names())


if __name__ == "__main__":
    unittest.main()
