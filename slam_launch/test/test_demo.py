# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demonstration of a product that is given as a file."""

import os
import pathlib
import subprocess
import tempfile
import unittest

from slam_launch import packages
import yaml

SECONDS = 3  # of the office
PRODUCT = "version: 1\nproduct: mine\nbackend: pf\nodometry: wheel\ndetector: apriltag\n"


class DemoOfFile(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def demo(self, content):
        """Calls the demonstration of a file named as a shipped product."""
        (self.folder / "ekf_wheel.yaml").write_text(content, encoding="utf-8")
        return subprocess.run([packages.program("slam_launch", "demo"), "ekf_wheel.yaml", "--dir",
                               self.folder], cwd=self.folder, env={**os.environ, "DISPLAY": ""},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)

    def test_runs_the_file_and_not_the_shipped_product_of_its_name(self):
        bag = self.folder / "bags" / "office.bag"
        bag.parent.mkdir()
        subprocess.run([packages.program("slam_sim", "slam_sim"), bag, "--duration", str(SECONDS),
                        "--only", "odom,camera"], check=True, stdout=subprocess.DEVNULL)
        done = self.demo(PRODUCT + "pf: {particles: 20}\n")
        self.assertEqual(done.returncode, 0, done.stdout)
        run = self.folder / "runs" / "demo_ekf_wheel" / "config.yaml"
        config = yaml.safe_load(run.read_text(encoding="utf-8"))
        self.assertEqual((config["product"], config["backend"]), ("mine", "pf"))
        self.assertEqual(config["pf"]["particles"], 20)

    def test_refuses_a_file_with_a_misspelt_parameter_before_it_simulates(self):
        done = self.demo(PRODUCT + "pf: {particels: 20}\n")
        self.assertEqual(done.returncode, 2)
        self.assertIn("unknown (did you mean 'particles'?)", done.stdout)
        self.assertNotIn("sena", done.stdout)
        self.assertFalse((self.folder / "bags").exists())


if __name__ == "__main__":
    unittest.main()
