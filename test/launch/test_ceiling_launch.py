# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""pf_visual and its like on the simulated office's first seconds: the same path in every way."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

from launching import play_into_launch, program, run_launch, run_offline, SameAsOffline

SECONDS = 8
CAMERAS = [f"/{camera}/{topic}" for camera in ("camera", "ceiling_camera")
           for topic in ("image_raw/compressed", "camera_info")]


class CeilingLaunchTest(SameAsOffline, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        cls.bag = cls.root / "office.bag"
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--duration", str(SECONDS),
                        "--only", "odom,camera,ceiling_camera"], check=True,
                       stdout=subprocess.DEVNULL)
        for product in ("pf_visual", "ekf_visual", "ekf_visual_wheel"):
            run_offline(cls.bag, cls.root / product, product=product)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def replay_without_loss(self, composition, backend, odometry):
        product = f"{backend}_{odometry}"
        run = self.root / f"{composition}_{product}"
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"composition:={composition}",
                               f"backend:={backend}", f"odometry:={odometry}",
                               f"output_dir:={run}")
        self.assert_same_runs(run, self.root / product, output)
        self.assertNotIn("acknowledged", output)

    def test_pubsub_without_loss_equals_offline(self):
        self.replay_without_loss("pubsub", "pf", "visual")

    def test_inprocess_without_loss_equals_offline(self):
        self.replay_without_loss("inprocess", "pf", "visual")

    def test_pubsub_with_the_wheels_behind_equals_offline(self):
        self.replay_without_loss("pubsub", "ekf", "visual_wheel")

    def test_inprocess_with_the_wheels_behind_equals_offline(self):
        self.replay_without_loss("inprocess", "ekf", "visual_wheel")

    def test_pubsub_in_real_time_equals_offline(self):
        run, offline = self.root / "played", self.root / "ekf_visual"
        output = play_into_launch(self.bag, ("/tf_static", *CAMERAS), 1, offline,
                                  "robot:=sim_segway", "odometry:=visual", f"output_dir:={run}")
        self.assert_same_runs(run, offline, output)
        self.assertNotIn("has died", output)

    def test_the_wheels_behind_may_be_told_as_a_transform_only(self):
        run, offline = self.root / "transforms", self.root / "ekf_visual_wheel"
        output = play_into_launch(self.bag, ("/tf", "/tf_static", *CAMERAS), 1, offline,
                                  "robot:=sim_segway", "odometry:=visual_wheel",
                                  f"output_dir:={run}")
        self.assertIn("odometry is taken from the transform odom -> base_link", output)
        self.assert_same_runs(run, offline, output)

    def test_the_wheels_are_kept_to_compare_with(self):
        wheels = (self.root / "pf_visual" / "wheel_odometry.tum").read_text(encoding="ascii")
        self.assertGreater(len(wheels.splitlines()), 40 * SECONDS)

    def test_what_visual_odometry_cannot_work_with_ends_the_launch(self):
        for setting, sentence in (
                ("ceiling_camera.ceiling_height=0", "ceiling_camera.ceiling_height is 0"),
                ("visual_odometry.features=orbs", "did you mean 'orb'?")):
            output, _ = run_launch(f"bag:={self.bag}", "odometry:=visual", f"set:={setting}")
            self.assertIn(sentence, output)


if __name__ == "__main__":
    unittest.main()
