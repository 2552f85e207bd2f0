# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""./slam compare: runs side by side."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.report import run_comparison  # noqa: E402


class RunComparison(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for name, seed, truth in (("a", 1, True), ("b", 2, False)):
            run_maker.make_run(cls.folder / name, seed=seed, count=60, truth=truth)
            (cls.folder / name / "config.yaml").write_text(
                f"product: {name}\nrobot: same\npf: {{particles: {seed}0, adapt: true}}\n")

    def call(self, *arguments):
        """Exit code, and what was printed to both streams."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = run_comparison.main([str(word) for word in arguments])
            except SystemExit as end:
                code = end.code
        return code, out.getvalue() + err.getvalue()

    def test_has_the_figures_settings_and_pictures_of_both(self):
        page = self.folder / "page.html"
        code, printed = self.call(self.folder / "a", self.folder / "b", "--out", page)
        self.assertEqual(code, 0, printed)
        error = next(line for line in printed.splitlines()
                     if line.startswith("Absolute trajectory error [m]"))
        self.assertEqual(error.split()[-1], "–", "the second run has no truth")
        self.assertGreater(float(error.split()[-2]), 0.0)
        text = page.read_text(encoding="utf-8")
        self.assertIn("<td>pf.particles</td><td>10</td><td>20</td>", text)
        self.assertNotIn("pf.adapt", text, "it is the same in both")
        self.assertEqual(text.count('alt="Path and map of '), 2)
        self.assertEqual(text.count('alt="Landmark errors of '), 1)

    def test_where_runs_come_from_is_shown_and_is_no_setting(self):
        run = {"version": "0.1.0", "commit": "abc", "bag": {"name": "x.bag", "bytes": 2500000}}
        metrics = (self.folder / "a" / "metrics.json")
        self.addCleanup(metrics.write_text, metrics.read_text())
        metrics.write_text(json.dumps({**json.loads(metrics.read_text()), "run": run}))
        page = self.folder / "page.html"
        code, printed = self.call(self.folder / "a", self.folder / "b", "--out", page)
        self.assertEqual(code, 0, printed)
        self.assertIn("<td>Bag</td><td>x.bag, 2.5 MB</td><td>–</td>", page.read_text("utf-8"))
        self.assertEqual(run_comparison.differences([{"run": run}, {"run": {}}]), {})

    def test_names_are_as_long_as_it_takes_to_tell_runs_apart(self):
        paths = [pathlib.Path("/runs/one/ekf"), pathlib.Path("/runs/two/ekf")]
        self.assertEqual(run_comparison.names_of(paths), ["one/ekf", "two/ekf"])
        self.assertEqual(run_comparison.names_of([paths[0], pathlib.Path("/pf")]), ["ekf", "pf"])
        with self.assertRaisesRegex(InputError, "given twice"):
            run_comparison.names_of([paths[0], paths[0]])

    def test_what_cannot_be_compared_ends_in_one_sentence(self):
        for arguments, code, words in (
                ((self.folder / "a",), 2, "give 2 to 12 folders"),
                ((self.folder / "a", self.folder / "none"), 1, "no such folder"),
                ((self.folder / "a", self.folder), 1, "holds no trajectory.tum"),
                ((self.folder / "a", self.folder / "a"), 1, "given twice"),
                ((self.folder / "a", self.folder / "b", "--out", self.folder / "no/page.html"), 1,
                 "cannot be written")):
            found, printed = self.call(*arguments)
            self.assertEqual(found, code, printed)
            self.assertIn(words, printed)
            self.assertNotIn("Traceback", printed)

    def test_settings_of_one_run_alone_differ(self):
        found = run_comparison.differences([{"a": {"b": 1, "c": [1, 2]}}, {"a": {"b": 1}}])
        self.assertEqual(found, {"a.c": ["[1, 2]", "–"]})


if __name__ == "__main__":
    unittest.main()
