# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a campaign out of the folders of its runs."""
import csv
import io
import json
import pathlib
import tempfile
import types
import unittest

import run_maker
from slam_eval.campaign import page, results
from slam_eval.campaign.folder import Folder
from slam_eval.campaign.plan import Row


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Folder(folder.name)
        self.campaign = types.SimpleNamespace(
            name="some", path=pathlib.Path(folder.name) / "some.yaml",
            bags=[types.SimpleNamespace(name=name) for name in ("x", "y")],
            products=[types.SimpleNamespace(name=name) for name in ("a", "b")],
            seeds=[1, 2], metrics=["ate_rmse_m", "landmark_rmse_m"])
        self.campaign.path.write_text("campaign: some\n", encoding="utf-8")

    def made(self, name, failure=None, **metrics):
        """The row's run with these figures, or one that failed."""
        run = self.folder.run(name)
        run_maker.make_run(run, count=60)
        (run / "metrics.json").write_text(json.dumps(metrics), encoding="utf-8")
        (run / "result.json").write_text(json.dumps({"failure": failure}), encoding="utf-8")
        return name

    def tables(self):
        rows = []
        for bag in "xy":
            for product in "ab":
                for seed in (1, 2):
                    error = 0.1 * seed + (0.01 if product == "b" else 0.0)
                    name = self.made(f"{bag}{product}{seed}", ate_rmse_m=error, cpu_s=1.5 * seed)
                    rows.append(Row(bag, product, seed, name))
        self.made("yb1", failure="the drive's bag lacks scans")
        rows[7] = Row("y", "b", 2, "not_there")
        return results.Tables(self.campaign, results.read_lines(self.folder, rows))


class Tables(InFolder):
    def test_hold_a_line_for_each_run(self):
        lines = list(csv.DictReader(io.StringIO(results.runs_csv(self.tables().lines))))
        self.assertEqual(len(lines), 8)
        self.assertEqual(lines[0]["ate_rmse_m"], "0.1")
        self.assertEqual([line["outcome"] for line in lines[6:]], ["failed", "missing"])
        self.assertEqual(lines[6]["why"], "the drive's bag lacks scans")

    def test_keep_what_differs_from_host_to_host_apart(self):
        tables = self.tables()
        self.assertNotIn("cpu_s", results.runs_csv(tables.lines))
        costs = list(csv.DictReader(io.StringIO(results.costs_csv(tables.lines))))
        self.assertEqual([line["cpu_s"] for line in costs[:2]], ["1.5", "3.0"])

    def test_hold_medians_and_quartiles(self):
        tables = self.tables()
        self.assertEqual(tables.metrics, ["ate_rmse_m"])  # nobody has the other
        self.assertAlmostEqual(tables.cells["ate_rmse_m", "a", "x"].quartiles[0], 0.15)
        self.assertEqual(tables.cells["ate_rmse_m", "b", "y"].quartiles, None)
        self.assertEqual(tables.cells["ate_rmse_m", "b", "y"].failed, 2)
        self.assertIn("0.1500 [0.1250, 0.1750]", page.text_table(tables, "ate_rmse_m"))
        self.assertIn("ate_rmse_m,a,x,2,0,", tables.table_csv())

    def test_compare_products(self):
        found, = self.tables().comparisons["ate_rmse_m"]
        self.assertEqual((found.smaller, found.larger), (2, 0))

    def test_count_equal_values_once_where_the_bag_is_the_same(self):
        for product, error in (("a", 0.1), ("b", 0.2)):
            self.made(product, ate_rmse_m=error)
        for bags, count in ((("same", "same"), 1), (("one", "other"), 2)):
            rows = [Row("x", product, seed, product, None, bag)
                    for product in "ab" for seed, bag in zip((1, 2), bags)]
            tables = results.Tables(self.campaign, results.read_lines(self.folder, rows))
            found, = tables.comparisons["ate_rmse_m"]
            self.assertEqual(found.smaller, count)


class Page(InFolder):
    def test_shows_tables_pictures_and_what_failed(self):
        tables = self.tables()
        text = page.render(self.campaign, self.folder, tables)
        for part in ("6 of 8 runs are complete, 1 failed, 1 are missing", "the drive&#x27;s bag "
                                                                          "lacks",
                     "campaign: some", "sign test", "Paths on x"):
            self.assertIn(part, text)
        self.assertEqual(text.count("data:image/png"), 3)

    def test_is_the_same_once_more(self):
        tables = self.tables()
        self.assertEqual(page.render(self.campaign, self.folder, tables),
                         page.render(self.campaign, self.folder, tables))

    def test_of_runs_that_all_failed_says_why(self):
        rows = [Row("x", "a", 1, None, "the drive cannot be simulated")]
        tables = results.Tables(self.campaign, results.read_lines(self.folder, rows))
        text = page.render(self.campaign, self.folder, tables)
        self.assertIn("the drive cannot be simulated", text)
        self.assertNotIn("data:image", text)


if __name__ == "__main__":
    unittest.main()
