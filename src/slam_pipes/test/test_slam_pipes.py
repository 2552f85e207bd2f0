# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products whose components are processes between pipes: the same bytes as in one process, and an end
with a sentence whatever dies."""

import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from nav_msgs.msg import Odometry
import rosbag
import rospy
from slam_msgs.msg import LandmarkObservation, LandmarkObservationArray

THESIS = ("ekf_wheel", "pf_wheel", "pf_visual", "ekf_wheel_pointmap", "pf_wheel_grid")
TIMES = re.compile(r"_ms_|_s$|^wall|realtime|rss")  # keys of metrics.json that say what a run cost
PATIENCE = 60  # [s] for what ends at once on a machine that is not busy
LIBRARY_OF_ROS = re.compile(r"lib(ros|tf2|nodelet|cpp_common|xmlrpcpp|class_loader)")


def program(package, name):
    return find_in_workspaces(["libexec"], package, name, first_match_only=True)[0]


def children(process):
    """Returns the command line of each child of a process by its id."""
    found = {}
    for path in pathlib.Path(f"/proc/{process}/task").glob("*/children"):
        for child in path.read_text(encoding="ascii").split():
            words = pathlib.Path(f"/proc/{child}/cmdline").read_bytes().decode().split("\0")
            found[int(child)] = words
    return found


def memory(process):
    """Returns what a process holds in memory [kB]."""
    status = pathlib.Path(f"/proc/{process}/status").read_text(encoding="ascii")
    return int(re.search(r"^VmRSS:\s*(\d+)", status, re.MULTILINE).group(1))


def written(process):
    """Returns what a process has written since it began [B]."""
    counts = pathlib.Path(f"/proc/{process}/io").read_text(encoding="ascii")
    return int(re.search(r"^wchar: (\d+)", counts, re.MULTILINE).group(1))


def wait_for(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("nothing happened")
        time.sleep(0.02)


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.home.name)
        cls.bag = cls.folder / "drive.bag"
        subprocess.run([program("slam_sim", "slam_sim"), cls.bag, "--duration", "6"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.home.cleanup()

    def run_on(self, name, product, out, bag=None, *arguments):
        return subprocess.run([name, product, "--bag", bag or self.bag, "--out", self.folder / out,
                               *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False, timeout=PATIENCE)

    def files(self, out):
        """Returns the content of each file of a run, of metrics.json without what the run cost."""
        found = {path.name: path.read_bytes() for path in (self.folder / out).iterdir()}
        metrics = json.loads(found.pop("metrics.json"))
        found["metrics.json"] = {key: value for key, value in metrics.items()
                                 if not TIMES.search(key)}
        return found

    def require_same_bytes(self, product, bag=None, *arguments):
        offline = self.run_on(program("slam_ros", "slam_offline"), product, "offline", bag, *arguments)
        self.assertEqual(offline.returncode, 0, offline.stderr)
        piped = self.run_on(program("slam_pipes", "slam_pipes"), product, "piped", bag, *arguments)
        self.assertEqual(piped.returncode, 0, piped.stderr)
        self.assertEqual(self.files("offline"), self.files("piped"), product)
        counted = [[line for line in text.splitlines() if line.startswith("counted")]
                   for text in (offline.stdout, piped.stdout)]
        self.assertEqual(*counted)
        return piped


class SameBytes(Runs):
    def test_as_in_one_process_for_the_thesis_s_products(self):
        for product in THESIS:
            with self.subTest(product):
                self.require_same_bytes(product)

    def test_with_stages_before_the_back_end(self):
        run = self.require_same_bytes("rat_wheel")
        self.assertIn("4 processes", run.stdout)

    def test_with_another_seed_and_setting(self):
        self.require_same_bytes("pf_wheel", None, "--seed", "7", "--set", "pf.particles=40")

    def test_with_two_detectors_at_each_of_two_cameras(self):
        bag = self.folder / "foyer.bag"
        subprocess.run([program("slam_sim", "slam_sim"), bag, "--world", "foyer", "--robot", "scout",
                        "--duration", "3", "--only", "odom,camera,rear_camera"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        run = self.require_same_bytes("ekf_wheel", bag, "--set", "second_detector=aruco",
                                      "--set", "second_camera=true")
        self.assertIn("6 processes", run.stdout)

    def test_with_two_lasers(self):
        bag = self.folder / "twin.bag"
        subprocess.run([program("slam_sim", "slam_sim"), bag, "--robot", "twin", "--duration", "5"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for product in ("scan_grid_wheel", "graph_wheel_grid"):
            self.require_same_bytes(product, bag, "--set", "rear_laser=true", "--set",
                                    "pointmap=true")

    def test_a_bag_that_nothing_can_be_made_of_is_refused_with_the_same_sentence(self):
        bag = self.folder / "no_mount.bag"
        with rosbag.Bag(str(self.bag)) as whole, rosbag.Bag(str(bag), "w") as part:
            for topic, message, time in whole.read_messages():
                if topic != "/tf_static":
                    part.write(topic, message, time)
        faults = []
        for package, name in (("slam_ros", "slam_offline"), ("slam_pipes", "slam_pipes")):
            run = self.run_on(program(package, name), "pf_wheel_grid", "nothing", bag)
            self.assertEqual(run.returncode, 1)
            faults.append(run.stderr.splitlines()[-1].partition(": ")[2])
        self.assertIn("does not tell the transform base_link -> laser", faults[0])
        self.assertEqual(*faults)

    def test_as_slam_run_starts_it(self):
        run = self.run_on(program("slam_ros", "slam_run"), "ekf_wheel", "run", None, "--middleware",
                          "pipes")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn(", 3 processes", run.stdout)
        self.assertIn("--middleware pipes", (self.folder / "run/metrics.json").read_text("utf-8"))

    def test_where_the_bag_carries_what_a_component_would_make(self):
        bag = self.folder / "observed.bag"
        with rosbag.Bag(str(bag), "w") as out:
            for tenth in range(100):
                stamp = rospy.Time.from_sec(1 + 0.1 * tenth)
                odometry = Odometry()
                odometry.header.stamp = stamp
                odometry.pose.pose.position.x = 0.02 * tenth
                odometry.pose.pose.orientation.w = 1.0
                out.write("odom", odometry, stamp)
                seen = LandmarkObservation(id=3, range=5 - 0.02 * tenth, bearing=0.01)
                array = LandmarkObservationArray(sequence=tenth, observations=[seen])
                array.header.stamp = stamp
                array.sensor_pose.x = 0.0
                out.write("observations", array, stamp)
        run = self.require_same_bytes("ekf_wheel", bag, "--robot", "sim_segway")
        self.assertIn("the detector is left out", run.stdout.replace(" 'apriltag'", ""))
        self.assertIn(", 2 processes", run.stdout)


class Components(unittest.TestCase):
    def test_run_without_ros(self):
        listed = subprocess.run(["ldd", program("slam_pipes", "slam_part")], text=True, check=True,
                                stdout=subprocess.PIPE).stdout
        names = [line.split()[0] for line in listed.splitlines()]
        self.assertIn("libslam_core_product.so", names)
        self.assertEqual([name for name in names if LIBRARY_OF_ROS.match(name)], [])


class Ends(Runs):
    """What happens when something dies in the middle of a run."""

    def start(self, product, out):
        run = subprocess.Popen([program("slam_pipes", "slam_pipes"), product, "--bag", self.bag,
                                "--out", self.folder / out], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        return run

    def parts(self, run):
        """Returns the id of each component's process by its part."""
        return {words[words.index("--part") + 1]: child for child, words in children(run.pid).items()
                if words[0].endswith("slam_part") and "--part" in words}

    def started(self, product, out):
        """A run whose steps have begun, with its processes."""
        run = self.start(product, out)
        trajectory = self.folder / out / "unfinished_run/trajectory.tum"
        wait_for(lambda: trajectory.exists())
        return run, self.parts(run)

    def stand_still(self, processes):
        """Whether processes that are not at their end write nothing for a while."""
        before = [written(process) for process in processes]
        time.sleep(0.5)
        return [written(process) for process in processes] == before

    def require_gone(self, processes):
        wait_for(lambda: not any(pathlib.Path(f"/proc/{process}").exists() for process in processes))

    def test_a_component_that_is_killed_ends_the_run_with_its_name(self):
        titles = {"odometry": "odometry source 'wheel'", "detector": "detector 'apriltag'",
                  "backend": "back-end 'ekf'"}
        for part, title in titles.items():
            with self.subTest(part):
                run, parts = self.started("ekf_wheel", f"killed_{part}")
                self.assertEqual(set(parts), set(titles))
                os.kill(parts[part], signal.SIGKILL)
                _, said = run.communicate(timeout=PATIENCE)
                self.assertEqual(run.returncode, 1)
                self.assertEqual(said, f"slam_pipes: the process of the {title} was ended by a signal "
                                 "(Killed): the run is not complete, start it again\n")
                self.require_gone(parts.values())
                self.assertFalse((self.folder / f"killed_{part}" / "config.yaml").exists())

    def test_the_files_of_an_earlier_run_stay(self):
        first = self.run_on(program("slam_pipes", "slam_pipes"), "pf_wheel_grid", "twice")
        self.assertEqual(first.returncode, 0, first.stderr)
        before = self.files("twice")
        run, parts = self.started("ekf_wheel", "twice")
        os.kill(parts["detector"], signal.SIGKILL)
        run.communicate(timeout=PATIENCE)
        self.assertEqual(run.returncode, 1)
        kept = {path.name: path for path in (self.folder / "twice").iterdir() if path.is_file()}
        self.assertEqual({name: kept[name].read_bytes() for name in before if name != "metrics.json"},
                         {name: text for name, text in before.items() if name != "metrics.json"})

    def test_no_component_is_left_where_the_starter_is_killed(self):
        run, parts = self.started("ekf_wheel_pointmap", "orphans")
        self.assertEqual(set(parts), {"odometry", "detector", "backend", "pointmap"})
        run.kill()
        run.wait(timeout=PATIENCE)
        self.require_gone(parts.values())

    def test_a_component_that_stands_still_holds_the_others_back_in_bounded_memory(self):
        run, parts = self.started("ekf_wheel", "slow")
        os.kill(parts["backend"], signal.SIGSTOP)
        processes = [run.pid, parts["odometry"], parts["detector"]]
        wait_for(lambda: self.stand_still(processes))  # the pipes are full
        before = [memory(process) for process in processes]
        self.assertTrue(self.stand_still(processes))
        for process, kilobytes in zip(processes, before):
            self.assertLess(memory(process) - kilobytes, 1000)
        self.assertIsNone(run.poll())
        os.kill(parts["backend"], signal.SIGCONT)
        _, said = run.communicate(timeout=PATIENCE)
        self.assertEqual(run.returncode, 0, said)
        self.run_on(program("slam_ros", "slam_offline"), "ekf_wheel", "offline")
        self.assertEqual(self.files("slow"), self.files("offline"))

    def test_a_folder_that_cannot_be_written_is_said_once(self):
        (self.folder / "taken").write_text("", encoding="ascii")
        run = self.run_on(program("slam_pipes", "slam_pipes"), "ekf_wheel", "taken")
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"^slam_pipes: the process of the back-end 'ekf' has failed: "
                         r"[^\n]*taken[^\n]*\n$")


class WrongUse(Runs):
    def refusal(self, *arguments, product="ekf_wheel"):
        run = self.run_on(program("slam_ros", "slam_run"), product, "refused", None, *arguments)
        self.assertEqual(run.returncode, 2)
        return run.stderr

    def test_of_a_middleware_is_refused(self):
        self.assertIn("there is no middleware 'pigeons': no package slam_pigeons",
                      self.refusal("--middleware", "pigeons"))

    def test_of_options_that_it_does_not_have_is_refused(self):
        for arguments in (["--online"], ["--autosave", "5"], ["--load-map", "map.yaml"]):
            self.assertIn(f"{arguments[0]} goes without --middleware",
                          self.refusal("--middleware", "pipes", *arguments))

    def test_of_a_parameter_is_said_before_a_process_is_started(self):
        run = self.run_on(program("slam_pipes", "slam_pipes"), "ekf_wheel", "wrong", None, "--set",
                          "ekf.gaet=3")
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"^slam_pipes: [^\n]*gaet[^\n]*\n$")
        self.assertFalse((self.folder / "wrong").exists())


if __name__ == "__main__":
    unittest.main()
