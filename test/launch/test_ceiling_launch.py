# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""ekf_visual on the simulated office's first seconds: the same path in every way to run."""

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
        for odometry in ("visual", "visual_wheel"):
            run_offline(cls.bag, cls.root / odometry, product=f"ekf_{odometry}")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def replay_without_loss(self, composition, odometry="visual"):
        run = self.root / f"{composition}_{odometry}"
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"composition:={composition}",
                               f"odometry:={odometry}", f"output_dir:={run}")
        self.assert_same_runs(run, self.root / odometry, output)
        self.assertNotIn("WARN", output)

    def test_pubsub_without_loss_equals_offline(self):
        self.replay_without_loss("pubsub")

    def test_inprocess_without_loss_equals_offline(self):
        self.replay_without_loss("inprocess")

    def test_pubsub_with_the_wheels_behind_equals_offline(self):
        self.replay_without_loss("pubsub", "visual_wheel")

    def test_inprocess_with_the_wheels_behind_equals_offline(self):
        self.replay_without_loss("inprocess", "visual_wheel")

    def test_pubsub_in_real_time_equals_offline(self):
        run = self.root / "played"
        output = play_into_launch(self.bag, ("/tf_static", *CAMERAS), 1, self.root / "visual",
                                  "robot:=sim_segway", "odometry:=visual", f"output_dir:={run}")
        self.assert_same_runs(run, self.root / "visual", output)
        self.assertNotIn("has died", output)

    def test_a_ceiling_without_height_ends_the_launch(self):
        output, _ = run_launch(f"bag:={self.bag}", "odometry:=visual",
                               "set:=visual_odometry.ceiling_height=0")
        self.assertIn("visual_odometry.ceiling_height is 0", output)


if __name__ == "__main__":
    unittest.main()
