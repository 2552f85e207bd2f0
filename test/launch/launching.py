# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls slam.launch and the programs as a user does."""

import contextlib
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import tempfile
import time

from catkin.find_in_workspaces import find_in_workspaces
import rosbag
import rospy
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import trajectory_error

RAWLOG = "/usr/share/mrpt/datasets/kf-slam_demo.rawlog"


def program(package, name):
    return find_in_workspaces(["libexec"], package, name, first_match_only=True)[0]


def make_demo_bag(path):
    """Imports the log of MRPT's demonstration, 70 landmarks."""
    subprocess.run([program("slam_eval", "slam_import"), "rawlog", RAWLOG, path], check=True,
                   stdout=subprocess.DEVNULL)


def make_drive_bag(path, seconds, streams):
    """Simulates the first seconds of a drive through the office, with some of the sensors."""
    subprocess.run([program("slam_sim", "slam_sim"), path, "--duration", str(seconds), "--only",
                    streams], check=True, stdout=subprocess.DEVNULL)


def largest_error(folder):
    """Returns the largest distance of an offline run's poses from the truth [m], without a fit."""
    run = read_run(folder)
    return trajectory_error(run.trajectory, run.truth, align=False).errors.max()


def cut_bag(whole, part, begin, end):
    """Writes the messages from begin to before end, in seconds of the log."""
    with rosbag.Bag(str(whole)) as source, rosbag.Bag(str(part), "w") as target:
        start = source.get_start_time()
        for topic, message, stamp in source.read_messages():
            if begin <= stamp.to_sec() - start < end:
                target.write(topic, message, stamp)


def run_offline(bag, folder, *options, product="ekf_wheel"):
    """Returns what slam_offline printed."""
    return subprocess.run([program("slam_ros", "slam_offline"), product, "--bag", bag, "--out",
                           folder, *options], check=True, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT).stdout


def free_port():
    """Returns a port below those that the system gives to connections, which could take it until the
    master does."""
    while True:
        port = random.randrange(12000, 32000)
        with socket.socket() as probe, contextlib.suppress(OSError):
            probe.bind(("127.0.0.1", port))
            return port


def start_launch(*arguments, port=None, namespace="/"):
    """Starts slam.launch with a master of its own, or with the one on a port."""
    port = port or free_port()
    environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}",
                   "ROS_NAMESPACE": namespace}
    launch = subprocess.Popen(["roslaunch", "-p", str(port), "slam_launch", "slam.launch",
                               *arguments], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return launch, environment


def output_of(launch):
    """Waits for a launch's end; returns what was printed."""
    try:
        return launch.communicate(timeout=100)[0]
    except subprocess.TimeoutExpired as fault:
        launch.send_signal(signal.SIGINT)  # which ends its nodes, too
        raise AssertionError(f"no end:\n{launch.communicate(timeout=40)[0]}") from fault
    finally:
        launch.kill()


def run_launch(*arguments):
    launch, _ = start_launch(*arguments)
    return output_of(launch), launch.returncode


def record_launch(product, bag, record, topics, composition="pubsub"):
    """Replays a bag through slam.launch and has topics recorded in the bag `record`; returns what
    was printed."""
    port = free_port()
    folder = pathlib.Path(__file__).resolve().parents[1] / "launch_products"
    return output_of(subprocess.Popen(
        ["roslaunch", "-p", str(port), folder / "recorded.launch", f"product:={product}",
         f"bag:={bag}", f"record:={record}", f"composition:={composition}",
         f"topics:={' '.join(sorted(topics))}"],
        env={**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}"},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True))


def stamp_of(landmarks):
    """Returns the line of a landmarks.yaml that tells its last step."""
    return next(line for line in landmarks.read_text(encoding="ascii").splitlines()
                if line.startswith("stamp"))


def wait_for_last_step(environment, offline, timeout=40):
    """Waits until the launch has come as far as the offline run did."""
    end = time.monotonic() + timeout
    with tempfile.TemporaryDirectory() as folder:
        saved = pathlib.Path(folder) / "landmarks.yaml"
        while time.monotonic() < end:
            subprocess.run(["rosservice", "call", "save_map", str(saved)], env=environment,
                           check=True, stdout=subprocess.DEVNULL)
            if stamp_of(saved) == stamp_of(offline / "landmarks.yaml"):
                return


def play_into_launch(bag, topics, rate, offline, *arguments):
    """Plays a bag's topics with `rosbag play`, ends the launch with Ctrl-C when it has come as far
    as the offline run; returns what it printed."""
    launch, environment = start_launch("use_sim_time:=true", "unsafe_paths:=true", *arguments)
    try:
        subprocess.run(["rosbag", "play", "-q", "--wait-for-subscribers", "--clock", "-r",
                        str(rate), bag, "--topics", *topics],
                       env=environment, check=True, timeout=60, stdout=subprocess.DEVNULL)
        wait_for_last_step(environment, offline)
        launch.send_signal(signal.SIGINT)
        return launch.communicate(timeout=40)[0]
    finally:
        launch.kill()


class SameAsOffline:
    """For a TestCase: compares a run's files with those of the offline run."""

    files = ("trajectory.tum", "trajectory_final.tum", "landmarks.yaml", "updates.csv")

    def assert_same_runs(self, run, offline, output):
        for name in self.files:
            self.assertTrue((run / name).exists(), output)
            self.assertEqual((run / name).read_bytes(), (offline / name).read_bytes(), name)
        self.assertGreater((run / "trajectory.tum").stat().st_size, 0)
        ours, theirs = (json.loads((folder / "metrics.json").read_text(encoding="ascii"))
                        for folder in (run, offline))
        self.assertEqual(ours["dropped_messages"], 0)
        self.assertEqual(ours["updates"], theirs["updates"])
        # a back-end's recorder knows neither what images and scans cost in other nodelets nor the bag
        self.assertEqual(*({key for key in metrics if not key.startswith(("latency_", "run"))}
                           for metrics in (ours, theirs)))


class Refusals:
    """For a TestCase: launches that end before any node starts."""

    def assert_refused(self, sentence, *arguments):
        output, code = run_launch(*arguments)
        self.assertNotEqual(code, 0)
        self.assertIn(sentence, output)
        self.assertNotIn("process[", output, "a node was started")


class ReplayOfProduct(SameAsOffline):
    """For a TestCase with the name of a product: both compositions do what the offline run does."""

    product = None
    seconds = 5  # of the log
    lacks_persist = None  # an input of a kind that cannot cross a pipe

    @classmethod
    def make_bag(cls, path):
        """Makes the bag; a product that takes other data has its own way."""
        make_demo_bag(cls.root / "whole.bag")
        cut_bag(cls.root / "whole.bag", path, 0, cls.seconds)

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        cls.make_bag(cls.root / "short.bag")
        run_offline(cls.root / "short.bag", cls.root / "offline", product=cls.product)

    def test_launches_in_both_compositions_as_offline(self):
        for composition in ("pubsub", "inprocess"):
            with self.subTest(composition):
                run = self.root / composition
                output, _ = run_launch(f"product:={self.product}", f"bag:={self.root}/short.bag",
                                       "rate:=0", f"composition:={composition}",
                                       f"output_dir:={run}")
                self.assert_same_runs(run, self.root / "offline", output)
                self.assertNotIn("was acknowledged", output)  # the bag source waited in vain

    def test_runs_between_pipes_as_offline(self):
        run = self.root / "pipes"
        done = subprocess.run([program("slam_pipes", "slam_pipes"), self.product, "--bag",
                               self.root / "short.bag", "--out", run], text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if self.lacks_persist:
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertRegex(done.stdout, f"'{self.lacks_persist}' .* cannot cross a pipe: give the "
                             "type a persist")
            self.assertFalse(run.exists())
        else:
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assert_same_runs(run, self.root / "offline", done.stdout)
