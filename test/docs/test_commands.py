# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the clone's own texts run, those of the README first."""

import unittest

from command_runs import CommandRuns
from doc_commands import Block, REPO, texts_of_root


class RootCommands(CommandRuns, unittest.TestCase):
    def test_that_fail_are_noticed(self):
        for text in ("true | false\n", "./slam check backend=ekf odometry=weel\n",
                     "roslaunch slam_launch slam.launch robot:=nobody\n"):
            with self.assertRaises(AssertionError, msg=text):
                self.run_block(Block(REPO / "README.md", 1, "sh", text))

    def test_run_as_they_stand_in_the_texts(self):
        self.assert_run(texts_of_root())
        self.assert_page_of_all_products(self.home / ".slam" / "runs" / "demo_all")

    def assert_page_of_all_products(self, folder):
        """What `./slam demo all`, a command of the README, is to leave behind."""
        page = (folder / "report.html").read_text(encoding="utf-8")
        for number in ("6.1", "6.2a", "6.2b", "6.3", "6.4", "6.5", "6.6a", "6.6b", "6.7", "6.8",
                       "6.9", "6.10"):
            self.assertIn(f"<figcaption>Figure {number}. ", page)
        self.assertEqual(page.count("data:image/"), 12)
        table = page[page.index("<table"):page.index("</table>")]
        self.assertEqual(table.count("<tr>"), 6)
        self.assertNotIn("–", table)  # a figure that is missing


if __name__ == "__main__":
    unittest.main()
