# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A launched product goes on from its checkpoint, and says so where it cannot."""

import os
import pathlib
import re
import signal
import subprocess
import tempfile
import threading
import time
import unittest
import xmlrpc.client

from geometry_msgs.msg import Twist
from launching import cut_bag, make_demo_bag, program, run_launch, run_offline, start_launch
import rosbag
import rosgraph
import rospy
from slam_eval.io.run_folder import read_run

SECONDS = 22  # of the log
AUTOSAVE = 1  # [s]
GOES_ON = re.compile(r"the product goes on from (\S+) of ([\d.]+) s")
NEAR = 0.3  # [m]
IMAGE = "/camera/image_raw/compressed"
IMAGES = ("/odom", IMAGE, "/camera/camera_info", "/tf_static")
IMAGE_PERIOD = 0.1  # [s]


def write_standstill(drive, target, seconds):
    """Writes what the drive's robot reports when it stands for seconds where the drive ends: the
    last two images by turns, since a camera that sends the same one again counts as hung."""
    last, images, steps = {}, [], int(seconds / IMAGE_PERIOD)
    with rosbag.Bag(str(drive)) as source, rosbag.Bag(str(target), "w") as bag:
        for topic, message, stamp in source.read_messages():
            last[topic] = message
            if topic == IMAGE:
                images.append(message)
            elif topic == "/odom":
                message.twist.twist = Twist()
            elif topic == "/tf_static":
                bag.write(topic, message, rospy.Time.from_sec(source.get_end_time()))
        for step in range(1, steps + 1):
            stamp = rospy.Time.from_sec(source.get_end_time() + step * IMAGE_PERIOD)
            last[IMAGE] = images[-1 - step % 2]
            for topic in set(IMAGES) - {"/tf_static"}:
                last[topic].header.stamp = stamp
                bag.write(topic, last[topic], stamp)


class Launch:
    """A launch of a live product with checkpoints; what it prints is collected."""

    def __init__(self, folder, *arguments, product="ekf_wheel", robot="mrpt_demo"):
        self.process, self.environment = start_launch(
            f"robot:={robot}", f"product:={product}", "use_sim_time:=true",
            f"checkpoints:={folder}", f"autosave:={AUTOSAVE}", *arguments)
        self.said = ""
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.end()
        self.reader.join()

    def _read(self):
        for line in self.process.stdout:
            self.said += line

    def wait_for(self, is_met, timeout=25):
        end = time.monotonic() + timeout
        while not is_met():
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError(self.said)
            time.sleep(0.05)

    def play(self, bag, rate, topics=("/odom", "/observations")):
        return subprocess.Popen(["rosbag", "play", "-q", "--wait-for-subscribers", "--clock", "-r",
                                 str(rate), bag, "--topics", *topics],
                                env=self.environment, stdout=subprocess.DEVNULL)

    def kill_manager(self):
        """As the system does that runs out of memory."""
        master = rosgraph.Master("/test", self.environment["ROS_MASTER_URI"])
        with xmlrpc.client.ServerProxy(master.lookupNode("/slam_manager")) as node:
            os.kill(node.getPid("/test")[2], signal.SIGKILL)

    def end(self, number=signal.SIGINT):
        self.process.send_signal(number)
        self.process.wait(timeout=20)
        self.reader.join()
        self.process.stdout.close()
        return self.said


class LiveCheckpointsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        make_demo_bag(cls.root / "whole.bag")
        for name, begin, end in (("drive", 0, SECONDS), ("first", 0, 8), ("second", 8, 16)):
            cut_bag(cls.root / "whole.bag", cls.root / f"{name}.bag", begin, end)
        run_offline(cls.root / "drive.bag", cls.root / "offline")
        cls.offline = read_run(cls.root / "offline").trajectory

    def assert_ends_near_offline(self, run):
        """The poses of a run are near those that an uninterrupted run has at the same stamps."""
        ours = read_run(run).trajectory
        theirs = dict(zip(self.offline.stamps, self.offline.poses))
        shared = [(pose, theirs[stamp]) for stamp, pose in zip(ours.stamps, ours.poses)
                  if stamp in theirs]
        self.assertGreater(len(shared), 3)
        for pose, expected in shared[len(shared) // 2:]:
            self.assertLess(abs(pose[0] - expected[0]) + abs(pose[1] - expected[1]), NEAR)

    def test_a_manager_that_is_killed_goes_on_where_it_was(self):
        run, folder = self.root / "killed_run", self.root / "killed"
        with Launch(folder, f"output_dir:={run}") as launch:
            player = launch.play(self.root / "drive.bag", 1)
            launch.wait_for(lambda: (folder / "checkpoint.previous").exists())
            launch.kill_manager()
            saved = checkpoint_time(folder)
            launch.wait_for(lambda: checkpoint_time(folder) > saved)
            player.wait(timeout=30)
            said = launch.end()
        found = GOES_ON.search(said)
        self.assertTrue(found, said)
        self.assertEqual(found.group(1), str(folder / "checkpoint"))
        self.assertIn("bridged", said)
        self.assert_ends_near_offline(run)
        self.assertLess(landmarks_of(self.root / "offline") - landmarks_of(run), 5)

    def test_a_launch_that_was_stopped_is_resumed(self):
        folder = self.root / "stopped"
        for part, number, composition in (("first", signal.SIGTERM, "inprocess"),
                                          ("second", signal.SIGINT, "inprocess")):
            run = self.root / f"{part}_run"
            with Launch(folder, f"output_dir:={run}", "resume:=true",
                        f"composition:={composition}") as launch:
                launch.play(self.root / f"{part}.bag", 3).wait(timeout=30)
                time.sleep(1)
                said = launch.end(number)
        found = GOES_ON.search(said)
        self.assertTrue(found, said)
        first = read_run(self.root / "first_run").trajectory
        self.assertAlmostEqual(float(found.group(2)), first.stamps[-1] * 1e-9, 2)
        self.assert_ends_near_offline(self.root / "second_run")
        self.assertGreater(landmarks_of(self.root / "second_run"),
                           landmarks_of(self.root / "first_run") - 1)

    def test_the_stages_before_a_back_end_go_on_with_it(self):
        folder, ended = self.root / "places", []
        drive, standstill = self.root / "gallery.bag", self.root / "standstill.bag"
        subprocess.run([program("slam_sim", "slam_sim"), drive, "--world", "gallery", "--duration",
                        "8", "--only", "odom,camera"], check=True, stdout=subprocess.DEVNULL)
        write_standstill(drive, standstill, 4)
        for bag in (drive, standstill):
            run = self.root / f"{bag.stem}_places"
            with Launch(folder, f"output_dir:={run}", "resume:=true", product="rat_wheel",
                        robot="sim_segway") as launch:
                launch.play(bag, 1, IMAGES).wait(timeout=40)
                time.sleep(1)
                ended.append(launch.end())
        self.assertTrue(GOES_ON.search(ended[1]), ended[1])
        for said in ended:
            self.assertNotIn("no checkpoint can be written", said)
        lines = (run / "places.csv").read_text(encoding="ascii").splitlines()[1:]
        places = [line.split(",") for line in lines]
        resumed = float(GOES_ON.search(ended[1]).group(2))
        before = [first for stamp, first in places if float(stamp) <= resumed]
        self.assertGreater(len(before), 60, "the way of the first part is there")
        # The robot stands where it was stopped, so it sees what it saw last, under the same number;
        # stages that had begun to count anew would take it for a new place or for the first one.
        after = [first for stamp, first in places if float(stamp) > resumed]
        self.assertTrue(any(first and resumed - 3 < float(first) <= resumed for first in after),
                        (resumed, after))

    def test_a_folder_that_cannot_be_made_ends_the_launch(self):
        (self.root / "file").write_text("", encoding="ascii")
        folder = self.root / "file" / "below"
        said, code = run_launch("robot:=mrpt_demo", f"checkpoints:={folder}")
        self.assertIn(f"cannot make the folder {folder} for checkpoints: Not a directory", said)
        self.assertIn("it is not started again", said)
        self.assertIn("REQUIRED process", said)
        self.assertIsNotNone(code)

    def test_a_damaged_checkpoint_and_a_second_product_are_reported(self):
        folder = self.root / "damaged"
        folder.mkdir()
        (folder / "checkpoint").write_text("SLAMCKPT", encoding="ascii")
        with Launch(folder, "resume:=true") as first:
            first.wait_for(lambda: "map and pose begin anew" in first.said)
            with Launch(folder) as second:
                second.process.wait(timeout=40)
            said = first.end()
        self.assertRegex(said, r"no checkpoint can be used: \S+/checkpoint: it is cut")
        self.assertEqual((folder / "checkpoint.unused").read_text(encoding="ascii"), "SLAMCKPT")
        self.assertIn(f"another run is writing into the folder {folder}", second.said)


def checkpoint_time(folder):
    return (folder / "checkpoint").stat().st_mtime_ns


def landmarks_of(run):
    return (run / "landmarks.yaml").read_text(encoding="ascii").count("id:")


if __name__ == "__main__":
    unittest.main()
