# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the README are those that a campaign in the repository prints: of its products, on its
bags, in its form. Their values take minutes, or data that cannot be shipped."""

import itertools
import os
import pathlib
import re
import tempfile
import unittest
import unittest.mock

from doc_commands import REPO
from slam_eval.campaign.campaign_file import read_campaign

CAMPAIGNS = REPO / "src" / "slam_eval" / "campaigns"
HEAD = re.compile(r"^\| product \|(.* \|)$\n^\|[-|]+\|$\n((?:^\| `.*\|$\n)+)", re.MULTILINE)
COLUMN = re.compile(r"`(\w+)`: ([^,]+)(, not aligned)?")  # a campaign and one of its bags
NUMBER = r"\d+\.\d{4}"
ONE, SEVERAL = re.compile(NUMBER), re.compile(rf"{NUMBER} \[{NUMBER}, {NUMBER}\]")
SHOWN = {None: "ate_rmse_m", ", not aligned": "ate_unaligned_rmse_m"}
LOOSE = re.compile(r"\b\d+(?:\.\d+)? ?(?:%|m|mm|cm|deg|ms|Hz)\b")  # a figure outside the table


def cells(row):
    return [cell.strip() for cell in row.strip().strip("|").split("|")]


def campaign(name, folder):
    """Returns what a shipped campaign's file says, with empty bags where data cannot be shipped."""
    text = (CAMPAIGNS / f"{name}.yaml").read_text(encoding="utf-8")
    for bag in re.findall(r"bag: \$SLAM_BAGS/([\w.]+)", text):
        (folder / bag).touch()
    with unittest.mock.patch.dict(os.environ, {"SLAM_BAGS": str(folder)}):
        return read_campaign(CAMPAIGNS / f"{name}.yaml")


class FiguresOfTheReadme(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.text = (REPO / "README.md").read_text(encoding="utf-8")
        found = HEAD.search(self.text)
        self.assertIsNotNone(found, "README.md has no table of figures")
        self.columns = [COLUMN.fullmatch(cell).groups() for cell in cells(found.group(1))]
        self.rows = [cells(row) for row in found.group(2).splitlines()]
        self.before = self.text[:found.start()].rsplit("\n## ", 1)[1]
        self.campaigns = {name: campaign(name, pathlib.Path(folder.name))
                          for name, _, _ in self.columns}

    def test_are_of_bags_that_their_campaigns_have(self):
        self.assertGreater(len(self.columns), 1)
        for name, bag, _ in self.columns:
            self.assertIn(bag, [each.name for each in self.campaigns[name].bags], name)

    def test_are_there_for_each_product_of_a_campaign_and_for_no_other(self):
        shown = [row[0].strip("`") for row in self.rows]
        self.assertEqual(len(set(shown)), len(shown))
        named = itertools.chain(*(each.products for each in self.campaigns.values()))
        self.assertEqual(set(shown), {product.name for product in named})
        for column, (name, _, _) in enumerate(self.columns, 1):
            filled = {row[0].strip("`") for row in self.rows if row[column]}
            self.assertEqual(filled, {product.name for product in self.campaigns[name].products})

    def test_look_as_the_campaign_prints_them(self):
        for column, (name, _, metric) in enumerate(self.columns, 1):
            self.assertIn(SHOWN[metric], self.campaigns[name].metrics)
            form = ONE if len(self.campaigns[name].seeds) == 1 else SEVERAL
            for row in self.rows:
                if row[column]:
                    self.assertRegex(row[column], rf"^{form.pattern}$", row[0])

    def test_come_with_the_command_that_prints_them(self):
        for name in self.campaigns:
            self.assertRegex(self.before, rf"`[^`]*\./slam campaign {name}`")

    def test_stand_nowhere_else_in_it(self):
        prose = re.sub(r"```.*?```", "", self.text, flags=re.DOTALL)
        self.assertEqual(LOOSE.findall(prose), [])


if __name__ == "__main__":
    unittest.main()
