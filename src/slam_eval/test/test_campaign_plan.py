# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The names of a campaign's runs: the same where the result is, another where it may not be."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import run_maker  # noqa: F401, before slam_eval: it finds the source tree
from slam_eval.bench.harness.programs import package_folder, workspace_program
from slam_eval.campaign import inputs
from slam_eval.campaign.campaign_file import read_campaign
from slam_eval.campaign.folder import Folder
from slam_eval.campaign.planner import NOT_SIMULATED, Planner
from slam_eval.io.errors import UsageError

CAMPAIGN = """
version: 1
campaign: some
bags: [{name: NAME, bag: BAG, robot: ROBOT}]
products: [{product: ekf_wheel, set: {ekf.gate_probability: GATE}}]
seeds: [SEED]
"""


class InFolder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.bag = cls.folder / "a.bag"
        subprocess.run([workspace_program("slam_sim", "slam_sim"), cls.bag, "--only", "odom",
                        "--duration", "2"], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        cls.robot = cls.folder / "own_robot.yaml"
        shutil.copy(package_folder("slam_launch") / "robots" / "sim_segway.yaml", cls.robot)

    def plan(self, text):
        path = self.folder / "some.yaml"
        path.write_text(text, encoding="utf-8")
        inputs.hash_of_file.cache_clear()
        return Planner(read_campaign(path), Folder(self.folder / "out"))

    def name(self, bag="a.bag", name="x", robot="sim_segway", gate="0.99", seed="1"):
        """The name of the only run."""
        text = CAMPAIGN
        for key, value in (("NAME", name), ("BAG", bag), ("ROBOT", robot), ("GATE", gate),
                           ("SEED", seed)):
            text = text.replace(key, value)
        return next(iter(self.plan(text).runs_plan().runs))


class Names(InFolder):
    def test_depend_on_what_files_hold_and_not_on_where_they_are(self):
        shutil.copy(self.bag, self.folder / "b.bag")
        self.assertEqual(self.name(), self.name(bag="b.bag", name="y"))
        moved = shutil.copy(self.robot, self.folder / "moved.yaml")
        self.assertEqual(self.name(robot=str(self.robot)), self.name(robot=str(moved)))

    def test_differ_where_results_may(self):
        names = [self.name(), self.name(gate="0.9"), self.name(seed="2"),
                 self.name(robot="sim_omni")]
        self.robot.write_text(self.robot.read_text(encoding="utf-8") + "# changed\n",
                              encoding="utf-8")
        names.append(self.name(robot=str(self.robot)))
        with open(self.folder / "c.bag", "wb") as copy:
            copy.write(self.bag.read_bytes() + b"\0")
        names.append(self.name(bag="c.bag"))
        self.assertEqual(len(set(names)), len(names))

    def test_hold_the_libraries_of_programs(self):
        program = workspace_program("slam_ros", "slam_offline")
        names = [pathlib.Path(path).name for path in inputs.libraries_of(program)]
        self.assertTrue(any(name.startswith("libslam_core") for name in names), names)
        self.assertEqual(inputs.libraries_of(self.robot), ())


class Drives(InFolder):
    TEXT = """
version: 1
campaign: some
bags: [{world: office, only: [odom], duration: 2, seed: SEED}]
products: [ekf_wheel]
seeds: 3
"""

    def test_that_are_the_same_are_simulated_once(self):
        self.assertEqual(len(self.plan(self.TEXT.replace("SEED", "7")).drives_plan().drives), 1)
        self.assertEqual(len(self.plan(self.TEXT.replace(", seed: SEED", ""))
                             .drives_plan().drives), 3)

    def test_that_are_missing_are_the_runs_failure(self):
        rows = self.plan(self.TEXT.replace("SEED", "7")).runs_plan().rows
        self.assertEqual([(row.run, row.failure) for row in rows], [(None, NOT_SIMULATED)] * 3)


class Robots(InFolder):
    def test_that_are_unknown_are_refused(self):
        with self.assertRaisesRegex(UsageError, "no robot 'sim_segwai' .did you mean 'sim_segway'"):
            self.name(robot="sim_segwai")


if __name__ == "__main__":
    unittest.main()
