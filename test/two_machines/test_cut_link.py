# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The front-end on one machine, the back-end on another: what crosses the link between them, and
what becomes of the run when the link is cut for a while."""

import contextlib
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from launching import program, run_offline
from namespaces import Link, why_not
import rosbag

HERE = pathlib.Path(__file__).resolve().parent
SECONDS = 22   # of the drive, played at the robot's own speed
BEFORE = 4     # [s] of them until the link is cut
CUT = 10       # [s]
PATIENCE = 40  # [s] for whatever has to come
IMAGES, ODOMETRY = "/camera/image_raw/compressed", "/odom"
TOPICS = (ODOMETRY, IMAGES, "/camera/camera_info", "/tf_static")
QUICK = "apriltag.quad_decimate=2"  # [1], so that a busy machine keeps up


def make_bag(path):
    subprocess.run([program("slam_sim", "slam_sim"), path, "--duration", str(SECONDS), "--only",
                    "odom,camera"], check=True, stdout=subprocess.DEVNULL)


class Run:
    """The two launches, the bag's player and who watches, each on its machine."""

    def __init__(self, root, stack):
        self.root, self.stack = root, stack
        self.link = Link()
        stack.callback(self.link.close)

    def start(self, name, machine, *words):
        log = self.stack.enter_context((self.root / f"{name}.log").open("w", encoding="utf-8"))
        process = self.link.start(machine, *words, stdout=log, stderr=subprocess.STDOUT)
        self.stack.callback(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def log(self, name):
        return (self.root / f"{name}.log").read_text(encoding="utf-8")

    def events(self, key):
        """Returns what the monitor has told of a kind."""
        lines = [line for line in self.log("monitor").splitlines() if line.startswith("{")]
        return [event for event in map(json.loads, lines) if key in event]

    def wait_for(self, condition, what):
        end = time.monotonic() + PATIENCE
        while not condition():
            if time.monotonic() > end:
                raise AssertionError(f"{what} did not come; the logs:\n" + "\n".join(
                    f"--- {path.stem}\n{path.read_text()[-3000:]}"
                    for path in sorted(self.root.glob("*.log"))))
            time.sleep(0.1)

    def drive(self, bag):
        """Plays the bag on the robot, cuts the link on the way, and ends when all is done."""
        launch = ["roslaunch", "--wait", "slam_launch", "slam.launch", "robot:=sim_segway",
                  "product:=ekf_wheel", f"set:={QUICK}"]
        front_end = self.start("frontend", "robot", "roslaunch", *launch[2:], "only:=frontend")
        back_end = self.start("backend", "desk", *launch, "only:=backend",
                              f"output_dir:={self.root}/run")
        self.start("monitor", "desk", HERE / "monitor.py")
        self.wait_for(lambda: self.events("crossing"), "the other half")
        self.bytes_before = self.link.bytes()
        player = self.start("player", "robot", "rosbag", "play", "-q", "--wait-for-subscribers",
                            bag, "--topics", *TOPICS)
        self.wait_for(lambda: len(self.events("pose")) >= 10 * BEFORE, "a pose")
        self.cut = time.monotonic()
        self.link.cut()
        time.sleep(CUT)
        self.link.mend()
        self.mended = time.monotonic()
        self.played = player.wait(PATIENCE)
        with rosbag.Bag(str(bag)) as content:
            images = content.get_message_count(IMAGES)
        # the image at the bag's very end may lie beyond its last odometry
        self.wait_for(lambda: len(self.events("pose")) >= images - 1, "the last pose")
        self.bytes_after = self.link.bytes()
        for process in (back_end, front_end):
            self.end(process)


class CutLinkTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if why_not():
            raise unittest.SkipTest(why_not())
        root = pathlib.Path(cls.enter(tempfile.TemporaryDirectory()))
        cls.bag = root / "drive.bag"
        make_bag(cls.bag)
        run_offline(cls.bag, root / "offline", "--set", QUICK)
        cls.offline, cls.online = root / "offline", root / "run"
        with contextlib.ExitStack() as stack:
            cls.run_ = Run(root, stack)
            cls.run_.drive(cls.bag)
            cls.poses, cls.states = cls.run_.events("pose"), cls.run_.events("state")
            cls.output = cls.run_.log("backend")

    @classmethod
    def enter(cls, manager):
        value = manager.__enter__()
        cls.addClassCleanup(manager.__exit__, None, None, None)
        return value

    def test_only_motion_and_observations_cross(self):
        self.assertEqual(self.run_.events("crossing")[0]["crossing"], ["/motion", "/observations"])

    def test_no_image_crosses(self):
        out, back = (after - before for before, after in
                     zip(self.run_.bytes_before, self.run_.bytes_after))
        with rosbag.Bag(str(self.bag)) as content:
            images = sum(len(message.data) for _, message, _ in
                         content.read_messages(topics=[IMAGES]))
        print(f"over the link: {out / SECONDS / 1e3:.1f} kB/s from the robot, "
              f"{back / SECONDS / 1e3:.1f} kB/s to it; the compressed images would be "
              f"{images / SECONDS / 1e3:.1f} kB/s", file=sys.stderr)
        self.assertGreater(out, 10000)
        self.assertLess(out, images / 4)

    def test_nothing_comes_while_the_link_is_cut_and_it_is_told(self):
        within = [event for event in self.states
                  if self.run_.cut + 5 < event["time"] < self.run_.mended]
        self.assertTrue(within)
        for event in within:
            self.assertEqual(event["level"], 1)
            self.assertRegex(event["state"], "stale: nothing has come on motion and observations "
                             "for [0-9]+ s")
        late = [event for event in self.poses
                if self.run_.cut + 1 < event["time"] < self.run_.mended]
        self.assertEqual(late, [])

    def test_the_run_goes_on_when_the_link_is_back(self):
        self.assertTrue([event for event in self.poses if event["time"] > self.run_.mended])
        self.assertRegex(self.output, "motion comes again after [0-9.]+ s")
        self.assertRegex(self.output, "observations comes again after [0-9.]+ s")
        self.assertNotIn("has died", self.output)

    def test_nothing_is_lost_but_time(self):
        last = self.states[-1]["values"]
        self.assertFalse({"lost", "late", "overflow"} & last.keys(), last)
        stamps = [event["pose"] for event in self.poses]
        self.assertEqual(stamps, sorted(set(stamps)))
        for name in ("trajectory.tum", "landmarks.yaml"):
            self.assertEqual((self.online / name).read_bytes(),
                             (self.offline / name).read_bytes(), name)


if __name__ == "__main__":
    unittest.main()
