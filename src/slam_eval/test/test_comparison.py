# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page and the table of several products."""
import base64
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402,F401  (finds the package)
from slam_eval.report import comparison  # noqa: E402
from slam_eval.report.metric_table import KEYS  # noqa: E402


class Comparison(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "map.png").write_bytes(b"a picture")
        (self.folder / "parts.svg").write_text("<svg/>")

    def chapter(self, name, metrics, pictures=1):
        shown = comparison.Picture(self.folder / "map.png", "Figure 1", "Walls & doors.")
        diagram = comparison.Picture(self.folder / "parts.svg", "Figure 2", "Boxes.")
        return comparison.Chapter(name, f"About <{name}>", "A text.", metrics, diagram,
                                  [shown] * pictures)

    def test_the_table_has_every_column_and_a_dash_for_what_is_missing(self):
        table = comparison.text_table([
            self.chapter("one", {"ate_rmse_m": 0.01234, "landmarks": 12}),
            self.chapter("another", {"cpu_s": 3.456})])
        lines = {line.split("  ")[0].strip(): line.split()[-2:] for line in table.splitlines()}
        self.assertEqual(lines["ATE [m]"], ["0.0123", "–"])
        self.assertEqual(lines["landmarks"], ["12", "–"])
        self.assertEqual(lines["CPU [s]"], ["–", "3.46"])
        self.assertEqual(len(lines), 1 + len(comparison.COLUMNS))

    def test_every_column_is_a_metric_that_the_page_explains(self):
        text = comparison.render("Title", "remark", [self.chapter("one", {})])
        for key in comparison.COLUMNS:
            self.assertIn(KEYS[key].meaning.split(";")[0].replace("'", "&#x27;"), text)

    def test_the_page_holds_its_pictures_and_leads_to_the_runs_reports(self):
        text = comparison.render("A & B", "remark",
                                 [self.chapter(name, {}) for name in ("one", "two")])
        self.assertIn("<h1>A &amp; B</h1>", text)
        self.assertIn("About &lt;one&gt;", text)
        self.assertIn("Figure 1. Walls &amp; doors.", text)
        self.assertEqual(text.count(base64.b64encode(b"a picture").decode()), 2)
        self.assertEqual(text.count("data:image/svg+xml;base64,"), 2)
        for name in ("one", "two"):
            self.assertIn(f'href="{name}/report.html"', text)
            self.assertIn(f'id="{name}"', text)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:|#|one/|two/)[^"]*"', text), [])

    def test_two_pictures_stand_side_by_side(self):
        for count, kind in ((1, "single"), (2, "pair")):
            text = comparison.render("t", "r", [self.chapter("one", {}, count)])
            self.assertIn(f'<div class="{kind}"><figure>', text)


if __name__ == "__main__":
    unittest.main()
