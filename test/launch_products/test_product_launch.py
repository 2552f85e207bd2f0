# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""slam.launch goes by the feature model: products of one's own by NAME or FILE, and bad input."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
from unittest import mock

from launching import (cut_bag, make_demo_bag, program, Refusals, run_launch, run_offline,
                       SameAsOffline)

SECONDS = 5  # of the log
ROBOT = "robot:=mrpt_demo"


def call(name, *words):
    return subprocess.run([program("slam_launch", name), *words], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.STDOUT, check=False)


class ProductLaunch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.root)
        home = mock.patch.dict(os.environ, {"XDG_CONFIG_HOME": str(cls.root / "config")})
        home.start()
        cls.addClassCleanup(home.stop)


class OwnProductTest(SameAsOffline, ProductLaunch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        make_demo_bag(cls.root / "whole.bag")
        cls.bag = cls.root / "short.bag"
        cut_bag(cls.root / "whole.bag", cls.bag, 0, SECONDS)
        cls.written = call("new", "mine", "backend=pf", "odometry=wheel", "detector=none",
                           "pf.particles=20")
        run_offline(cls.bag, cls.root / "offline", product="mine")

    def launch(self, name, *arguments):
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"output_dir:={self.root / name}",
                               *arguments)
        self.assert_same_runs(self.root / name, self.root / "offline", output)
        return output

    def test_new_tells_the_file_that_it_writes(self):
        self.assertEqual(self.written.returncode, 0, self.written.stdout)
        self.assertTrue(pathlib.Path(self.written.stdout.strip()).is_file())

    def test_its_name_is_all_that_a_launch_needs(self):
        for composition in ("pubsub", "inprocess"):
            with self.subTest(composition):
                output = self.launch(composition, "product:=mine", f"composition:={composition}")
                self.assertNotIn("fiducial_detector", output)

    def test_its_file_is_all_that_a_launch_needs(self):
        self.launch("file", f"product:={self.written.stdout.strip()}")

    def test_slam_run_knows_its_name(self):
        for options in ((), ("--online",)):
            with self.subTest(options=options):
                run = self.root / ("run" + "".join(options))
                done = subprocess.run([program("slam_ros", "slam_run"), "mine", "--bag", self.bag,
                                       "--out", run, *options], stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, text=True, check=False)
                self.assert_same_runs(run, self.root / "offline", done.stdout)

    def test_the_list_of_parts_of_earlier_launches_is_removed(self):
        home = self.root / "ros_home"
        (home / "slam").mkdir(parents=True)
        old = [home / "slam" / f"parts_old{end}" for end in (".launch", "_robot.yaml")]
        for path in old:
            path.touch()
            os.utime(path, (0, 0))
        with mock.patch.dict(os.environ, {"ROS_HOME": str(home)}):
            self.launch("clean", "product:=mine")
        self.assertFalse(any(path.exists() for path in old))
        self.assertEqual(len(list((home / "slam").glob("*.launch"))), 1)


class BadInputTest(Refusals, ProductLaunch):
    """The same sentence from the launch as from `check`, and nothing has been started."""

    def file(self, content):
        path = self.root / "product.yaml"
        path.write_text("product: p\n" + content, encoding="utf-8")
        return path

    def assert_file_refused(self, sentence, content):
        path = self.file(content)
        self.assert_refused(sentence, f"product:={path}", ROBOT)
        checked = call("check", path)
        self.assertEqual(checked.returncode, 1)
        self.assertIn(sentence, checked.stdout)

    def test_a_feature_that_does_not_exist_names_the_nearest(self):
        self.assert_refused("backend=efk is not a feature; backend is one of: ekf, seif, graph, "
                            "pf, grid",
                            "backend:=efk", ROBOT)
        self.assert_refused("did you mean 'aruco'?", "detector:=aruko", ROBOT)
        self.assert_file_refused("odometry=visul is not a feature; odometry is one of: wheel, "
                                 "wheel_imu, visual, visual_wheel, visual_imu, laser, laser_wheel, "
                                 "laser_imu, command, none (did you mean 'visual'?)",
                                 "version: 1\nbackend: ekf\nodometry: visul\n")

    def test_a_product_that_does_not_exist_names_the_nearest(self):
        self.assert_refused("did you mean 'pf_wheel'?", "product:=fp_wheel", ROBOT)

    def test_a_missing_mandatory_feature_is_named(self):
        self.assert_file_refused("a product needs odometry (one of: wheel, wheel_imu, visual, "
                                 "visual_wheel",
                                 "version: 1\nbackend: ekf\n")

    def test_two_of_a_one_of_group_are_named(self):
        self.assert_file_refused("backend is ekf and pf; a product has exactly one of: ekf, "
                                 "seif, graph, pf, grid",
                                 "version: 1\nbackend: [ekf, pf]\nodometry: wheel\n")

    def test_a_product_and_another_feature_contradict_each_other(self):
        self.assert_refused("the product ekf_wheel is backend=ekf odometry=wheel", "backend:=pf",
                            "product:=ekf_wheel", ROBOT)

    def test_a_file_from_a_newer_version_is_named(self):
        self.assert_file_refused("has version 7, which is newer than this program",
                                 "version: 7\nbackend: ekf\nodometry: wheel\n")

    def test_a_parameter_of_a_feature_that_is_not_chosen_is_named(self):
        sentence = "pf.particles is a parameter of backend=pf, which is not chosen"
        self.assert_file_refused(sentence, "version: 1\nbackend: ekf\nodometry: wheel\n"
                                 "pf: {particles: 20}\n")
        self.assert_refused(sentence, "backend:=ekf", "set:=pf.particles=20", ROBOT)

    def test_a_parameter_that_no_component_reads_is_named(self):
        product = "version: 1\nbackend: ekf\nodometry: wheel\n"
        self.assert_file_refused("unknown (did you mean 'gate_probability'?)",
                                 product + "ekf: {gate_probabilty: 0.9}\n")
        self.assert_file_refused("2 is not allowed; the range is (0, 1)",
                                 product + "ekf: {gate_probability: 2}\n")

    def test_an_argument_that_does_not_exist_is_named(self):
        self.assert_refused("slam.launch: there is no argument 'backned' (did you mean "
                            "'backend'?)", "backned:=pf", ROBOT)

    def test_slam_run_says_the_same_with_exit_code_2(self):
        path = self.file("version: 7\nbackend: ekf\nodometry: wheel\n")
        done = subprocess.run([program("slam_ros", "slam_run"), path, "--bag", "x.bag", "--out",
                               self.root / "run"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has version 7, which is newer than this program", done.stdout)


if __name__ == "__main__":
    unittest.main()
