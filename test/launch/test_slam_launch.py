# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""slam.launch as a user calls it: replay equals the offline run, wrong arguments end at once."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from launching import (cut_bag, free_port, make_demo_bag, play_into_launch, program, Refusals,
                       run_launch, run_offline, SameAsOffline)
import rospkg
import yaml

SECONDS = 15  # of the log


class SlamLaunchTest(SameAsOffline, Refusals, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        whole = cls.root / "whole.bag"
        make_demo_bag(whole)
        cls.bag = cls.root / "short.bag"
        cut_bag(whole, cls.bag, 0, SECONDS)
        run_offline(cls.bag, cls.root / "offline")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def assert_same_as_offline(self, run, output):
        self.assert_same_runs(run, self.root / "offline", output)

    def replay_without_loss(self, composition):
        run = self.root / f"{composition}_0"
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"composition:={composition}",
                               f"output_dir:={run}")
        self.assert_same_as_offline(run, output)

    def replay_three_times_as_fast(self, composition):
        run = self.root / f"{composition}_3"
        output = play_into_launch(self.bag, ("/odom", "/observations"), 3, self.root / "offline",
                                  "robot:=mrpt_demo", f"composition:={composition}",
                                  f"output_dir:={run}")
        self.assert_same_as_offline(run, output)
        self.assertNotIn("has died", output)

    def test_pubsub_without_loss_equals_offline(self):
        self.replay_without_loss("pubsub")

    def test_inprocess_without_loss_equals_offline(self):
        self.replay_without_loss("inprocess")

    def test_pubsub_at_rate_3_equals_offline(self):
        self.replay_three_times_as_fast("pubsub")

    def test_inprocess_at_rate_3_equals_offline(self):
        self.replay_three_times_as_fast("inprocess")

    def test_unknown_robot_names_those_there_are(self):
        self.assert_refused("mrclam, mrpt_demo", "robot:=marvin")

    def test_a_key_that_stands_twice_in_a_file_is_named(self):
        robot = self.root / "twice.yaml"
        robot.write_text("version: 1\nrobot: twice\nwheel_odometry: {alpha1: 1}\n"
                         "wheel_odometry: {alpha1: 2}\n", encoding="utf-8")
        self.assert_refused("wheel_odometry stands there a second time", f"robot:={robot}")

    def test_maps_by_id_reach_the_nodelets(self):
        robot = self.root / "sizes.yaml"
        robot.write_text("version: 1\nrobot: sizes\nfiducial:\n  marker_sizes: {5: 0.2, 7: 0.5}\n",
                         encoding="utf-8")
        run = self.root / "sizes"
        output, _ = run_launch(f"robot:={robot}", f"bag:={self.bag}", "rate:=0",
                               "composition:=inprocess", f"output_dir:={run}")
        self.assertTrue((run / "config.yaml").exists(), output)
        self.assertIn("marker_sizes: {5: 0.2, 7: 0.5}",
                      (run / "config.yaml").read_text(encoding="ascii"))

    def test_a_robot_file_is_checked_before_the_start(self):
        robot = self.root / "wrong.yaml"
        for entry, sentence in (("alpha1: lots", f"{robot}:4: 'lots' is not of type number"),
                                ("alpah1: 1", "did you mean 'alpha1'?"),
                                ("alpha1: -1", "-1 is not allowed; the range is >= 0, in m^2/m")):
            with self.subTest(entry):
                robot.write_text(f"version: 1\nrobot: wrong\nwheel_odometry:\n  {entry}\n",
                                 encoding="utf-8")
                self.assert_refused(sentence, f"robot:={robot}")

    def test_a_feature_is_not_set_but_given(self):
        self.assert_refused("is a feature, not a parameter: give backend:=pf", "robot:=mrclam",
                            "set:=backend=pf")
        self.assert_refused("seed is set twice, to 3 and to 4", "robot:=mrclam", "seed:=3",
                            "set:=seed=4")

    def test_misspelt_robot_names_the_nearest(self):
        self.assert_refused("did you mean 'mrclam'?", "robot:=mrcalm")

    def test_localization_needs_a_map(self):
        self.assert_refused("load_map:=FILE", "mode:=localization", "robot:=mrclam")

    def test_unknown_key_ends_the_launch_with_the_nearest_name(self):
        self.assert_refused("did you mean 'gate_probability'?", "robot:=mrclam",
                            "set:=ekf.gate_probabilty=0.9")

    def test_output_folder_that_cannot_be_made_is_told(self):
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", "output_dir:=/proc/no_folder_here")
        self.assertIn("cannot make the output folder /proc/no_folder_here", output)

    @unittest.skipUnless(os.geteuid() == 0, "only root can mount a small disk")
    def test_full_disk_is_told_and_leaves_no_run_that_looks_complete(self):
        disk = self.root / "small"
        disk.mkdir()
        mount = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=24k", "tmpfs", disk],
                               check=False)
        if mount.returncode != 0:
            self.skipTest("this machine does not let root mount")
        try:
            output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"output_dir:={disk}/run")
            self.assertIn("is the disk full?", output)
            self.assertFalse((disk / "run" / "config.yaml").exists())
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_rviz_is_given_a_robot_to_show(self):
        master = f"http://localhost:{free_port()}"  # where none is
        for rviz in ("true", "false"):
            done = subprocess.run(["roslaunch", "--dump-params", "slam_launch", "slam.launch",
                                   "robot:=husky", f"rviz:={rviz}"], check=True, text=True,
                                  env={**os.environ, "ROS_MASTER_URI": master},
                                  stdout=subprocess.PIPE)
            self.assertEqual("<robot name=\"slam_launch/husky\">" in
                             yaml.safe_load(done.stdout).get("/robot_description", ""),
                             rviz == "true")

    def test_each_shipped_product_and_robot_loads(self):
        share = pathlib.Path(rospkg.RosPack().get_path("slam_launch"))
        products = sorted((share / "products").glob("*.yaml"))
        robots = sorted((share / "robots").glob("*.yaml"))
        self.assertTrue(products and robots)
        for product in products:
            for robot in robots:
                has_height = "ceiling_height:" in robot.read_text(encoding="ascii")
                with self.subTest(product=product.stem, robot=robot.stem):
                    done = subprocess.run([program("slam_ros", "slam_offline"), product, "--robot",
                                           robot, "--bag", self.bag, "--out",
                                           self.root / "shipped"], stdout=subprocess.DEVNULL,
                                          stderr=subprocess.PIPE, text=True, check=False)
                    if any(name in product.stem for name in ("pointmap", "grid", "laser")):
                        self.assertIn("lacks laser scans", done.stderr)
                    elif "command" in product.stem:
                        self.assertIn("lacks commands: 'cmd_vel_out'", done.stderr)
                    elif "imu" in product.stem:
                        self.assertIn("an IMU's angular velocities", done.stderr)
                    elif not has_height and ("visual" in product.stem or "ceiling" in product.stem):
                        self.assertIn("ceiling_height is 0", done.stderr)
                    elif any(name in product.stem for name in ("mono", "rat_")):
                        self.assertIn("lacks images", done.stderr)
                    elif "visual" in product.stem:
                        self.assertIn("lacks images of the ceiling", done.stderr)
                    else:  # the bag brings the observations of a detector
                        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
