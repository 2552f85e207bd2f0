# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns from end to end: killed and resumed, failed runs, wrong use."""
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest

from campaigns import (command_lines, InFolder, kill_one, processes_of, program, require_snakemake,
                       results, RUNS, TINY, WITHIN)
import rospkg
from slam_eval.campaign.folder import locked


def setUpModule():
    require_snakemake()


class Campaign(InFolder):
    """One that was never stopped is what all others are held against."""

    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory(prefix="slam_campaigns_")
        cls.path = pathlib.Path(cls.home.name) / "tiny.yaml"
        cls.path.write_text(TINY, encoding="utf-8")
        cls.whole = pathlib.Path(cls.home.name) / "whole"
        cls.done = cls.call(cls.path, "--out", cls.whole, "--jobs", 2)

    @classmethod
    def tearDownClass(cls):  # nose calls no class cleanups
        cls.home.cleanup()

    def test_makes_tables_and_a_page(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout)
        self.assertEqual(len(results(self.whole)), RUNS)
        self.assertRegex(self.done.stdout, r"scan_grid_wheel +0\.\d{4} \[0\.\d{4}, 0\.\d{4}\]")
        self.assertIn(f"8 of {RUNS} runs are complete, 4 failed", self.done.stdout)
        page = (self.whole / "report.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("data:image/png"), 4)

    def test_goes_on_after_a_run_that_failed_and_says_why(self):
        for text in (self.done.stdout, (self.whole / "runs.csv").read_text(encoding="utf-8")):
            self.assertIn("slam_offline: the drive's bag lacks landmarks", text)

    def test_says_how_far_it_is(self):
        self.assertIn("drives: 4, of which 0 are there", self.done.stdout)
        self.assertIn(f"runs: {RUNS} of {RUNS} are there", self.done.stdout)

    def test_holds_no_time_and_no_host(self):
        texts = "".join((self.whole / name).read_text(encoding="utf-8")
                        for name in ("runs.csv", "table.csv", "tests.csv"))
        for word in ("cpu_s", "wall_s", "_ms_", "rss", "/tmp", r"20\d\d-"):
            self.assertNotRegex(texts, word)
        self.assertIn("cpu_s", (self.whole / "costs.csv").read_text(encoding="utf-8"))

    def test_runs_nothing_again(self):
        before = results(self.whole)
        said = self.run_campaign(self.path, self.whole)
        self.assertIn(f"runs: {RUNS}, of which {RUNS} are there", said)
        self.assertEqual(results(self.whole), before)

    def test_that_is_killed_and_resumed_gives_the_same_bytes(self):
        out = self.folder / "killed"
        self.kill_at(self.path, out, count=3)
        before = results(out)
        self.assertTrue(3 <= len(before) < RUNS, len(before))
        self.run_campaign(self.path, out)
        after = results(out)
        self.assertEqual({name: after[name] for name in before}, before)
        self.assert_same_tables(self.whole, out)
        self.assertEqual(list((out / "unfinished").iterdir()), [])

    def test_whose_own_process_is_killed_leaves_no_snakemake(self):
        out = self.folder / "alone"
        with subprocess.Popen([program("slam_campaign"), self.path, "--out", out],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while len(results(out)) < 2 and process.poll() is None:
                time.sleep(0.05)
            process.kill()
        limit = time.monotonic() + 5
        while engines := [line for line in command_lines(out).values() if b"--snakefile" in line]:
            self.assertLess(time.monotonic(), limit, engines)
        self.run_campaign(self.path, out)
        self.assert_same_tables(self.whole, out)

    def test_makes_a_run_again_that_has_lost_its_result(self):
        out = self.folder / "lost"
        self.run_campaign(self.path, out)
        name, inode = sorted(results(out).items())[0]
        (out / "runs" / name / "result.json").unlink()
        self.run_campaign(self.path, out)
        self.assertNotEqual(results(out)[name], inode)
        self.assert_same_tables(self.whole, out)

    def test_runs_again_what_was_ended_from_outside(self):
        text = TINY.replace("[segway, turtlebot3]", "[segway]").replace("seeds: 2", "seeds: 1")
        path = self.write(text.replace("scan_grid, scan_grid_wheel, ekf_wheel",
                                       "{product: pf_wheel_grid, set: {pf.particles: 400}}"))
        out = self.folder / "ended"
        with subprocess.Popen([program("slam_campaign"), path, "--out", out], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            self.assertTrue(kill_one("slam_offline", out, process))
            said, _ = process.communicate(timeout=WITHIN)
        self.assertEqual(process.returncode, 0, said)
        self.assertIn("1 of 1 runs are complete", said)

    def test_that_is_ended_leaves_nothing_behind(self):
        out = self.folder / "left"
        with subprocess.Popen([program("slam_campaign"), self.path, "--out", out],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while not results(out) and process.poll() is None:
                time.sleep(0.05)
            process.terminate()
            self.assertEqual(process.wait(WITHIN), 128 + signal.SIGTERM)
        self.assertEqual(processes_of(out), [])

    def test_that_grows_runs_what_is_new_alone(self):
        out = self.folder / "grown"
        small = TINY.replace("[segway, turtlebot3]", "[segway]").replace("seeds: 2", "seeds: 1")
        small = small.replace(", scan_grid_wheel, ekf_wheel", "")
        self.run_campaign(self.write(small), out)
        before = results(out)
        self.assertEqual(len(before), 1)
        self.run_campaign(self.write(small.replace("seeds: 1", "seeds: 2")), out)
        after = results(out)
        self.assertEqual(len(after), 2)
        self.assertEqual({name: after[name] for name in before}, before)

    def test_runs_again_what_failed_where_that_is_asked_for(self):
        out = self.folder / "again"
        text = TINY.replace("[segway, turtlebot3]", "[segway]").replace("seeds: 2", "seeds: 1")
        path = self.write(text.replace("scan_grid, scan_grid_wheel, ", ""))
        self.run_campaign(path, out)
        before = results(out)
        self.run_campaign(path, out)
        self.assertEqual(results(out), before)
        self.run_campaign(path, out, "--retry")
        self.assertNotEqual(results(out), before)

    def test_refuses_the_folder_of_another_one(self):
        other = self.write(TINY.replace("campaign: tiny", "campaign: other"))
        self.refuses(other, "--out", self.whole, says=["holds the campaign 'tiny', not 'other'"])
        (self.folder / "full").mkdir()
        (self.folder / "full/file").touch()
        self.refuses(self.path, "--out", self.folder / "full", says=["holds no campaign", "--out"])

    def test_refuses_the_folder_that_another_call_works_in(self):
        with locked(self.whole / "lock", wait=False):
            self.refuses(self.path, "--out", self.whole, SLAM_COMMAND="slam",
                         says=["another call of slam campaign works in", "wait for its end"])


class Shipped(InFolder):
    def shortened(self, name):
        """A shipped campaign, on drives of some seconds with one seed."""
        path = pathlib.Path(rospkg.RosPack().get_path("slam_eval")) / "campaigns" / f"{name}.yaml"
        text = re.sub(r"duration: \d+", "duration: 3", path.read_text(encoding="utf-8"))
        return self.write(re.sub(r"seeds: \d+", "seeds: 1", text), f"{name}.yaml")

    def test_campaigns_run(self):
        for name, count in (("office", 8), ("lasers", 10), ("cameras", 12)):
            said = self.run_campaign(self.shortened(name), self.folder / name)
            self.assertIn(f"{count} of {count} runs are complete", said)

    def test_campaigns_are_known_by_name(self):
        self.refuses("offices", says=["no campaign 'offices' (did you mean 'office'?)"])


class WrongUse(InFolder):
    def out(self):
        return "--out", self.folder / "out"

    def tearDown(self):
        self.assertFalse((self.folder / "out").exists())

    def test_is_told_of_unknown_products(self):
        self.refuses(self.write(TINY.replace("scan_grid,", "scan_gird,")), *self.out(),
                     says=["no product 'scan_gird' (did you mean 'scan_grid'?)"])

    def test_is_told_of_unknown_parameters(self):
        text = TINY.replace("ekf_wheel]", "{product: ekf_wheel, set: {ekf.gate_probabilty: 0.9}}]")
        self.refuses(self.write(text), *self.out(), says=["gate_probabilty", "gate_probability"])

    def test_is_told_of_unknown_worlds_and_robots(self):
        self.refuses(self.write(TINY.replace("office", "ofice")), *self.out(),
                     says=["no world 'ofice' (did you mean 'office'?)"])
        self.refuses(self.write(TINY.replace("segway", "segwey")), *self.out(),
                     says=["no simulated robot 'segwey' (did you mean 'segway'?)"])

    def test_is_told_of_unknown_foreign_systems_and_their_parameters(self):
        text = TINY.replace("ekf_wheel]", "{foreign: mrpt_rbfp}]")
        self.refuses(self.write(text), *self.out(), says=["(did you mean 'mrpt_rbpf'?)"])
        text = TINY.replace("ekf_wheel]", "{foreign: mrpt_rbpf, set: {particle: 3}}]")
        self.refuses(self.write(text), *self.out(), says=["(did you mean 'particles'?)"])

    def test_is_told_of_values_that_a_foreign_system_cannot_take(self):
        for system, parameter, value, says in (
                ("mrpt_rbpf", "particles", 0, "it has to be a whole number above 0"),
                ("mrpt_rbpf", "particles", 2.5, "it has to be a whole number above 0"),
                ("mrpt_rbpf", "distance", -1, "it has to be above 0"),
                ("mrpt_kf", "motion_sigma", -1, "it has to be 0 or above"),
                ("mrpt_kf", "range_sigma", 0, "it has to be above 0")):
            text = TINY.replace("ekf_wheel]",
                                f"{{foreign: {system}, set: {{{parameter}: {value}}}}}]")
            self.refuses(self.write(text), *self.out(),
                         says=[f"the parameter {parameter} is '{value}'; {says}"])

    def test_is_told_of_files_that_are_none(self):
        self.refuses(self.folder / "nothing.yaml", *self.out(), says=["there is no such file"])
        self.refuses(self.write("- a\n- [\n"), *self.out(), says=["no valid YAML"])
        self.refuses(self.write(TINY.replace("world: office", "bag: lost.bag").replace(
            "[segway, turtlebot3], only: [odom, scan], duration: 5", "segway")), *self.out(),
            says=["there is no bag", "lost.bag"])

    def test_is_told_of_unknown_profiles(self):
        self.refuses(self.write(TINY), *self.out(), "--profile", "slum",
                     says=["there is no profile 'slum'", "slurm"])

    def test_is_told_which_package_brings_snakemake(self):
        self.refuses(self.write(TINY), *self.out(), PATH="/nowhere",
                     says=["install Debian's package snakemake"])

    def test_is_told_of_options_that_are_none(self):
        done = self.call(self.write(TINY), "--jobs", "0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--jobs", done.stdout)


if __name__ == "__main__":
    unittest.main()
