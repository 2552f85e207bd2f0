# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""slam.launch as a user calls it: replay equals the offline run, wrong arguments end at once."""

import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import unittest

from catkin.find_in_workspaces import find_in_workspaces
import rosbag
import rospkg

RAWLOG = "/usr/share/mrpt/datasets/kf-slam_demo.rawlog"
SECONDS = 15  # of the log


def program(package, name):
    return find_in_workspaces(["libexec"], package, name, first_match_only=True)[0]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def start_launch(*arguments):
    """Starts slam.launch with a master of its own."""
    port = free_port()
    environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}"}
    launch = subprocess.Popen(["roslaunch", "-p", str(port), "slam_launch", "slam.launch",
                               *arguments], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return launch, environment


def run_launch(*arguments):
    launch, _ = start_launch(*arguments)
    try:
        return launch.communicate(timeout=100)[0], launch.returncode
    finally:
        launch.kill()


class SlamLaunchTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp())
        whole = cls.root / "whole.bag"
        subprocess.run([program("slam_eval", "slam_import"), "rawlog", RAWLOG, whole], check=True,
                       stdout=subprocess.DEVNULL)
        cls.bag = cls.root / "short.bag"
        with rosbag.Bag(str(whole)) as source, rosbag.Bag(str(cls.bag), "w") as short:
            start = source.get_start_time()
            for topic, message, stamp in source.read_messages():
                if stamp.to_sec() < start + SECONDS:
                    short.write(topic, message, stamp)
        subprocess.run([program("slam_ros", "slam_offline"), "ekf_wheel", "--bag", cls.bag, "--out",
                        cls.root / "offline"], check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def assert_same_as_offline(self, run, output):
        for name in ("trajectory.tum", "landmarks.yaml", "updates.csv"):
            self.assertTrue((run / name).exists(), output)
            self.assertEqual((run / name).read_bytes(),
                             (self.root / "offline" / name).read_bytes(), name)
        self.assertGreater((run / "trajectory.tum").stat().st_size, 0)
        metrics = json.loads((run / "metrics.json").read_text(encoding="ascii"))
        self.assertEqual(metrics["dropped_messages"], 0)
        offline = json.loads((self.root / "offline" / "metrics.json").read_text(encoding="ascii"))
        self.assertEqual(metrics["updates"], offline["updates"])
        self.assertEqual(metrics.keys(), offline.keys())

    def replay_without_loss(self, composition):
        run = self.root / f"{composition}_0"
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"composition:={composition}",
                               f"output_dir:={run}")
        self.assert_same_as_offline(run, output)

    def replay_three_times_as_fast(self, composition):
        run = self.root / f"{composition}_3"
        launch, environment = start_launch("robot:=mrpt_demo", "use_sim_time:=true",
                                           f"composition:={composition}", f"output_dir:={run}")
        try:
            subprocess.run(["rosbag", "play", "-q", "--wait-for-subscribers", "--clock", "-r", "3",
                            self.bag, "--topics", "/odom", "/observations"], env=environment,
                           check=True, timeout=60, stdout=subprocess.DEVNULL)
            launch.send_signal(signal.SIGINT)
            output, _ = launch.communicate(timeout=40)
        finally:
            launch.kill()
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

    def assert_ends_with(self, sentence, *arguments):
        output, code = run_launch(*arguments)
        self.assertNotEqual(code, 0)
        self.assertIn(sentence, output)
        self.assertNotIn("process[", output, "a node was started")

    def test_combination_that_makes_no_product_names_the_nearest(self):
        self.assert_ends_with("The nearest valid product is ekf_wheel", "map:=grid",
                              "robot:=mrclam")

    def test_unknown_robot_names_those_there_are(self):
        self.assert_ends_with("there are: mrclam, mrpt_demo", "robot:=marvin")

    def test_misspelt_robot_names_the_nearest(self):
        self.assert_ends_with("did you mean 'mrclam'?", "robot:=mrcalm")

    def test_localization_needs_a_map(self):
        self.assert_ends_with("load_map:=FILE", "mode:=localization", "robot:=mrclam")

    def test_unknown_key_ends_the_launch_with_the_nearest_name(self):
        output, _ = run_launch("robot:=mrclam", "set:=ekf.gate_probabilty=0.9")
        self.assertIn("did you mean 'gate_probability'?", output)

    def test_output_folder_that_cannot_be_made_is_told(self):
        output, _ = run_launch(f"bag:={self.bag}", "rate:=0", "output_dir:=/proc/no_folder_here")
        self.assertIn("cannot make the output folder /proc/no_folder_here", output)

    @unittest.skipUnless(os.geteuid() == 0, "only root can mount a small disk")
    def test_full_disk_is_told_and_leaves_no_run_that_looks_complete(self):
        disk = self.root / "small"
        disk.mkdir()
        mount = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=24k", "tmpfs", disk], check=False)
        if mount.returncode != 0:
            self.skipTest("this machine does not let root mount")
        try:
            output, _ = run_launch(f"bag:={self.bag}", "rate:=0", f"output_dir:={disk}/run")
            self.assertIn("is the disk full?", output)
            self.assertFalse((disk / "run" / "config.yaml").exists())
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_each_shipped_product_and_robot_loads(self):
        share = pathlib.Path(rospkg.RosPack().get_path("slam_launch"))
        products = sorted((share / "products").glob("*.yaml"))
        robots = sorted((share / "robots").glob("*.yaml"))
        self.assertTrue(products and robots)
        for product in products:
            for robot in robots:
                with self.subTest(product=product.stem, robot=robot.stem):
                    subprocess.run([program("slam_ros", "slam_offline"), product, "--robot", robot,
                                    "--bag", self.bag, "--out", self.root / "shipped"], check=True,
                                   stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    unittest.main()
