# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""docs/parameters.md says what the programs read: it is what `./slam parameters` prints."""

import os
import re
import subprocess
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from doc_commands import REPO
import yaml

PAGE = REPO / "docs" / "parameters.md"
PROGRAM = find_in_workspaces(["libexec"], "slam_ros", "slam_parameters", first_match_only=True)[0]


def parameters(*arguments):
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env={**os.environ, "SLAM_COMMAND": "./slam"}, text=True, check=False)


class Parameters(unittest.TestCase):
    def test_the_page_is_what_the_code_says(self):
        self.assertEqual(PAGE.read_text(encoding="utf-8"), parameters().stdout,
                         "./slam parameters > docs/parameters.md writes it anew")

    def test_every_key_of_the_shipped_files_is_on_it(self):
        page = PAGE.read_text(encoding="utf-8")
        files = [*REPO.glob("slam_launch/products/*.yaml"), *REPO.glob("slam_launch/robots/*.yaml")]
        self.assertGreater(len(files), 10)
        for file in files:
            for section, values in yaml.safe_load(file.read_text(encoding="utf-8")).items():
                if not isinstance(values, dict):
                    continue
                table = re.search(rf"## Section `{section}`\n(.*?)(\n## |\Z)", page, re.DOTALL)
                self.assertTrue(table, f"{file.name}: {section}")
                for key in values:
                    self.assertIn(f"\n| `{key}` |", table.group(1), f"{file.name}: {section}")

    def test_a_section_is_printed_alone(self):
        printed = parameters("ekf")
        self.assertEqual(printed.returncode, 0)
        self.assertIn("| `gate_probability` |", printed.stdout)
        self.assertEqual(printed.stdout.count("\n## ") + printed.stdout.startswith("## "), 1)
        self.assertIn("| `backend` | product |", parameters("top").stdout)

    def test_a_file_is_checked_without_a_word_when_all_is_well(self):
        product = REPO / "slam_launch" / "products" / "pf_wheel.yaml"
        checked = parameters("--check", product, "--set", "pf.particles=20", "seed=3")
        self.assertEqual((checked.returncode, checked.stdout, checked.stderr), (0, "", ""))
        refused = parameters("--check", product, "--set", "pf.particels=20")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("did you mean 'particles'?", refused.stderr)
        self.assertEqual(parameters("--product-parameter", "pf").returncode, 1)

    def test_an_unknown_section_or_library_is_named(self):
        refused = parameters("efk")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("there is no section 'efk' (did you mean 'ekf'?); there are: top, ",
                      refused.stderr)
        self.assertEqual(parameters("--sections").returncode, 2)
        missing = parameters("--library", "libnowhere.so")
        self.assertEqual(missing.returncode, 1)
        self.assertIn("libnowhere.so", missing.stderr)


if __name__ == "__main__":
    unittest.main()
