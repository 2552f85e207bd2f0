# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program slam_doctor as it is called: exit codes, sentences, JSON, picture, live."""
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time
import unittest

from drives import drive, edited, FOLDER, views
import rosbag
from slam_eval.bench.adverse.changes import FrozenLaser, MirroredLaser

PROGRAM = pathlib.Path(__file__).resolve().parents[1] / "scripts" / "slam_doctor"


def call(*arguments, **environment):
    """Runs the program."""
    return subprocess.run(["python3", str(PROGRAM), *map(str, arguments)], text=True,
                          capture_output=True, check=False, timeout=120,
                          env={**os.environ, **environment})


class BadInput(unittest.TestCase):
    """One sentence, and exit code 2 for wrong use or 1 for a file that cannot be read."""

    def refused(self, code, text, *arguments):
        done = call(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertIn(text, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_a_missing_file(self):
        self.refused(2, "there is no bag /nowhere/x.bag", "/nowhere/x.bag")

    def test_a_folder(self):
        self.refused(2, "is a folder", FOLDER)

    def test_a_device(self):
        self.refused(2, "not a bag", "/dev/null")

    def test_an_empty_file(self):
        path = FOLDER / "empty_file.bag"
        path.write_bytes(b"")
        self.refused(1, "cannot read the bag", path)

    def test_a_bag_without_messages(self):
        path = FOLDER / "empty.bag"
        rosbag.Bag(str(path), "w").close()
        self.refused(1, "holds no messages", path)

    def test_a_file_that_is_no_bag(self):
        path = FOLDER / "text.bag"
        path.write_text("Hello.\n" * 1000, encoding="utf-8")
        self.refused(1, "cannot read the bag", path)

    def test_a_damaged_bag(self):
        content = bytearray(drive().read_bytes())
        content[8000:60000] = bytes(52000)
        path = FOLDER / "damaged.bag"
        path.write_bytes(content)
        self.refused(1, "is it damaged", path)

    def test_a_bag_that_was_not_closed(self):
        path = FOLDER / "cut.bag"
        path.write_bytes(drive().read_bytes()[:400000])
        self.refused(1, "cut.bag", path)

    def test_an_unknown_robot_or_product(self):
        self.refused(2, "there is no robot 'segwai' (did you mean", drive(), "--robot", "segwai")
        self.refused(2, "there is no product 'ekf'", drive(), "--product", "ekf")

    def test_a_robot_file_that_is_none(self):
        path = FOLDER / "broken.yaml"
        path.write_text("version: [1\n", encoding="utf-8")
        self.refused(2, "broken.yaml", drive(), "--robot", path)

    def test_files_that_cannot_be_written(self):
        for option in ("--json", "--plot"):
            done = call(drive(), option, "/nowhere/out.png")
            self.assertEqual(done.returncode, 1)
            self.assertIn("slam_doctor: cannot write /nowhere/out.png", done.stderr)

    def test_a_picture_of_no_known_kind(self):
        done = call(drive(), "--plot", FOLDER / "out.xyz")
        self.assertEqual(done.returncode, 1)
        self.assertIn("out.xyz", done.stderr)

    def test_options_that_are_none(self):
        for arguments in ((), (drive(), "--prodcut", "x"), ("live", "--seconds", "-1"),
                          ("live", "--seconds", "nan"), ("live", "--seconds", "soon")):
            self.assertEqual(call(*arguments).returncode, 2, arguments)
        self.assertIn("did you mean --product", call(drive(), "--prodcut", "x").stderr)


class Output(unittest.TestCase):
    def test_a_clean_drive(self):
        done = call(drive())
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\n\d+ OK, 0 WARN, 0 ERROR, \d+ cannot tell\n$")
        self.assertLess(max(map(len, done.stdout.splitlines())), 101)

    def test_a_fault_has_advice_and_the_exit_code_1(self):
        done = call(edited("mirrored_program", MirroredLaser(0.0)))
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"(?m)^ERROR +the scans turn against odometry")
        self.assertRegex(done.stdout, r"(?m)^ +-> Is the laser mounted upside down")

    def test_the_same_for_scripts(self):
        path = FOLDER / "findings.json"
        done = call(edited("frozen_program", FrozenLaser(20.0)), "--json", path)
        told = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual((done.returncode, told["version"], told["worst"]), (1, 1, "error"))
        self.assertEqual(told["source"], "frozen_program.bag")
        found = {each["check"]: each for each in told["findings"]}
        self.assertEqual(found["scan.frozen"]["level"], "error")
        self.assertTrue(found["scan.frozen"]["advice"])
        self.assertGreater(found["scan.frozen"]["value"], 30.0)
        self.assertEqual(len(told["findings"]), len(found))

    def test_a_picture(self):
        for bag in (drive(), views()):
            path = FOLDER / f"{bag.stem}.png"
            call(bag, "--plot", path)
            self.assertEqual(path.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_the_same_bag_gives_the_same_findings(self):
        first, second = (call(drive()).stdout.split("Computer")[0] for _ in range(2))
        self.assertEqual(first, second)


def free_port():
    """A port that nobody uses."""
    with socket.socket() as listener:
        listener.bind(("", 0))
        return listener.getsockname()[1]


@unittest.skipUnless(shutil.which("rosmaster") and shutil.which("rosbag"), "no rosmaster, rosbag")
class Live(unittest.TestCase):
    def start(self, *command):
        process = subprocess.Popen(command, env={**os.environ, "ROS_MASTER_URI": self.uri},
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(process.wait)
        # A player that waits hears no other signal.
        self.addCleanup(os.killpg, process.pid, signal.SIGKILL)
        return process

    def setUp(self):
        port = free_port()
        self.uri = f"http://localhost:{port}"
        self.port = port

    def with_master(self):
        self.start("rosmaster", "--core", "-p", str(self.port))
        time.sleep(2.0)

    def test_without_a_master(self):
        done = call("live", "--seconds", "1", ROS_MASTER_URI=self.uri)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no ROS master answers", done.stderr)

    def test_with_nobody_who_publishes(self):
        self.with_master()
        done = call("live", "--seconds", "1", ROS_MASTER_URI=self.uri)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no message came", done.stderr)

    def test_a_robot(self):
        self.with_master()
        # Stamps of a recorded drive are years behind the clock: the fault that must be told.
        self.start("rosbag", "play", "--delay", "3", str(drive()))
        path = FOLDER / "live.json"
        done = call("live", "--seconds", "8", "--json", path, ROS_MASTER_URI=self.uri)
        self.assertEqual(done.returncode, 1, done.stderr)
        found = {each["check"]: each for each in json.loads(path.read_text())["findings"]}
        self.assertEqual(found["scan.clock"]["level"], "error")
        self.assertAlmostEqual(found["scan.rate"]["value"], 10.0, delta=0.5)
        self.assertEqual(found["scan.mount"]["level"], "ok")
        self.assertIn("pf_wheel_grid", found["product"]["text"])


if __name__ == "__main__":
    unittest.main()
