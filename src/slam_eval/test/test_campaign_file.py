# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Campaign files: what they say, and one sentence for each thing that is wrong with one."""
import os
import pathlib
import subprocess
import tempfile
import unittest
import unittest.mock

import run_maker  # noqa: F401, before slam_eval: it finds the source tree
from slam_eval.bench.harness.programs import package_folder, workspace_program
from slam_eval.campaign.campaign_file import read_campaign, SENSORS
from slam_eval.io.errors import UsageError

GOOD = """
version: 1
campaign: some
bags:
  - world: office
    robot: [segway, omni]
    only: [odom, scan]
    duration: 20
  - {name: own, bag: own.bag, robot: turtlebot2}
products:
  - ekf_wheel
  - product: pf_wheel
    set: {pf.resample_below: 0.4}
    vary: {pf.particles: [30, 100], association.ids: [true, false]}
  - foreign: mrpt_rbpf
seeds: 3
"""


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "own.bag").write_bytes(b"#ROSBAG V2.0\n")
        self.path = self.folder / "some.yaml"

    def read(self, text):
        self.path.write_text(text, encoding="utf-8")
        return read_campaign(self.path)

    def refuses(self, text, *parts):
        with self.assertRaises(UsageError) as caught:
            self.read(text)
        sentence = str(caught.exception)
        self.assertNotIn("\n", sentence)
        for part in (str(self.path), *parts):
            self.assertIn(part, sentence)


class GoodFile(InFolder):
    def test_names_bags_products_and_seeds(self):
        campaign = self.read(GOOD)
        self.assertEqual([bag.name for bag in campaign.bags],
                         ["office segway", "office omni", "own"])
        self.assertEqual([row.name for row in campaign.products], [
            "ekf_wheel", "pf_wheel pf.particles=30 association.ids=true",
            "pf_wheel pf.particles=30 association.ids=false",
            "pf_wheel pf.particles=100 association.ids=true",
            "pf_wheel pf.particles=100 association.ids=false", "mrpt_rbpf"])
        self.assertEqual(campaign.products[1].settings,
                         ("pf.resample_below=0.4", "pf.particles=30", "association.ids=true"))
        self.assertEqual([row.is_foreign for row in campaign.products], [False] * 5 + [True])
        self.assertEqual(campaign.seeds, [1, 2, 3])
        self.assertEqual(campaign.size, 54)

    def test_finds_bags_in_the_folder_that_a_variable_names(self):
        text = GOOD.replace("bag: own.bag", "bag: $SLAM_TEST_BAGS/own.bag")
        with unittest.mock.patch.dict(os.environ, {"SLAM_TEST_BAGS": str(self.folder)}):
            self.assertEqual(self.read(text).bags[-1].path, self.folder / "own.bag")
        self.refuses(text, "the environment variable SLAM_TEST_BAGS names, which is not set; call "
                     "the command with SLAM_TEST_BAGS=FOLDER in front")

    def test_finds_files_from_its_own_folder(self):
        self.assertEqual(self.read(GOOD).bags[2].path, self.folder / "own.bag")

    def test_may_remap_topics_of_a_bag(self):
        text = GOOD.replace("turtlebot2}", 'turtlebot2, remap: "scan:=laser"}')
        own = self.read(text.replace("foreign: mrpt_rbpf", "pf_wheel_grid")).bags[2]
        self.assertEqual(own.remap, ("scan:=laser",))
        self.refuses(text, "the bag own has 'remap'", "the foreign system mrpt_rbpf does not take")

    def test_simulates_with_the_seed_of_the_run_or_its_own(self):
        drive = self.read(GOOD).bags[0]
        self.assertEqual([drive.drive_seed(seed) for seed in (1, 7)], [1, 7])
        fixed = self.read(GOOD.replace("    duration: 20", "    duration: 20\n    seed: 5")).bags[0]
        self.assertEqual([fixed.drive_seed(seed) for seed in (1, 7)], [5, 5])

    def test_may_list_its_seeds(self):
        self.assertEqual(self.read(GOOD.replace("seeds: 3", "seeds: [4, 2]")).seeds, [4, 2])

    def test_may_name_every_sensor_of_the_simulated_robots(self):
        named = set()
        for robot in sorted((package_folder("slam_sim") / "robots").glob("*.yaml")):
            done = subprocess.run([workspace_program("slam_sim", "slam_sim"), self.folder / "x.bag",
                                   "--robot", robot, "--only", "nothing"], text=True, check=False,
                                  stderr=subprocess.PIPE)
            self.assertIn("there are: ", done.stderr)
            named.update(done.stderr.partition("there are: ")[2].strip().split(", "))
        self.assertEqual(named, set(SENSORS))
        only = self.read(GOOD.replace("odom, scan", ", ".join(SENSORS))).bags[0].only
        self.assertEqual(only, SENSORS)


class BadFile(InFolder):
    def test_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(UsageError, "nothing.yaml: there is no such file"):
            read_campaign(self.folder / "nothing.yaml")

    def test_that_is_no_yaml_is_refused_with_the_line(self):
        self.refuses("version: 1\ncampaign: [\n", "some.yaml:3", "no valid YAML")
        self.refuses("just words\n", "not a map of keys and values")
        self.refuses("", "not a map of keys and values")

    def test_with_a_key_that_is_a_list_or_a_map_is_refused_with_the_place(self):
        for key in ("[1, 2]", "{a: b}", "? [1, 2]\n"):
            self.refuses(GOOD + f"{key}: 3\n", f"some.yaml:{GOOD.count(chr(10)) + 1}",
                         "column", "a key is one word or number")

    def test_with_a_key_twice_is_refused(self):
        self.refuses(GOOD + "seeds: 4\n", "the key 'seeds' stands there a second time")

    def test_with_an_unknown_key_is_refused_with_the_nearest(self):
        self.refuses(GOOD.replace("seeds", "seed"), "no key 'seed' (did you mean 'seeds'?)")
        self.refuses(GOOD.replace("duration", "durations"), "(did you mean 'duration'?)")
        self.refuses(GOOD.replace("vary", "varies"), "(did you mean 'vary'?)")

    def test_without_what_it_needs_is_refused(self):
        for key in ("campaign: some", "version: 1"):
            self.refuses(GOOD.replace(key + "\n", ""), key.split(":")[0])
        self.refuses("version: 1\ncampaign: a\nbags: [{world: office}]\n", "'products' is missing")
        self.refuses(GOOD.replace("bag: own.bag, ", ""), "neither 'bag'")
        self.refuses(GOOD.replace("foreign: mrpt_rbpf", "name: nobody"), "'product' or 'foreign'")

    def test_of_another_version_is_refused(self):
        self.refuses(GOOD.replace("version: 1", "version: 2"), "this program reads 'version: 1'")

    def test_names_a_bag_that_is_missing(self):
        self.refuses(GOOD.replace("own.bag", "lost.bag"), "there is no bag", "lost.bag")

    def test_with_two_of_a_name_is_refused(self):
        self.refuses(GOOD.replace("name: own", "name: office omni"),
                     "two bags are called 'office omni'")
        self.refuses(GOOD.replace("foreign: mrpt_rbpf", "product: ekf_wheel"),
                     "two products are called 'ekf_wheel'")
        self.refuses(GOOD.replace("seeds: 3", "seeds: [1, 2, 1]"), "the seed 1 stands there twice")

    def test_with_a_parameter_set_and_varied_is_refused(self):
        self.refuses(GOOD.replace("pf.resample_below: 0.4", "pf.particles: 3"),
                     "pf.particles stands in 'set' and in 'vary'")

    def test_with_values_of_another_kind_is_refused(self):
        self.refuses(GOOD.replace("seeds: 3", "seeds: many"), "no whole number")
        self.refuses(GOOD.replace("seeds: 3", "seeds: 0"), "a campaign needs one at least")
        self.refuses(GOOD.replace("duration: 20", "duration: -1"), "no number above 0")
        self.refuses(GOOD.replace("duration: 20", "duration: .nan"), "no number above 0")
        self.refuses(GOOD.replace("odom, scan", "odom, scam"), "(did you mean 'scan'?)")
        self.refuses(GOOD.replace("{pf.resample_below: 0.4}", "[1]"), "a map of parameters")
        self.refuses(GOOD.replace("{pf.resample_below: 0.4}", "{pf: {particles: 3}}"),
                     "SECTION.KEY: VALUE")
        self.refuses(GOOD.replace("[30, 100]", "[]"),
                     "vary: pf.particles is an empty list; give one value at least")
        self.refuses(GOOD.replace("campaign: some", "campaign: a/b"), "is no name of a campaign")

    def test_with_an_unknown_metric_is_refused(self):
        self.refuses(GOOD + "metrics: [ate_rmse]\n", "(did you mean 'ate_rmse_m'?)")
        self.refuses(GOOD + "metrics: [cpu_s]\n", "is a cost", "costs.csv")

    def test_of_too_many_runs_is_refused(self):
        self.refuses(GOOD.replace("seeds: 3", "seeds: 20000"), "more than 100000")


if __name__ == "__main__":
    unittest.main()
