# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of slam_run; what it starts has tests of its own."""

import contextlib
import fcntl
import importlib.machinery
import importlib.util
import io
import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

import rosgraph

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "slam_run"


def load():
    loader = importlib.machinery.SourceFileLoader("slam_run", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("slam_run", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


slam_run = load()
PRODUCT = "version: 1\nproduct: p\nbackend: ekf\nodometry: wheel\nmap: landmarks\nseed: 1\n"
REQUIRED = ["p.yaml", "--bag", "x.bag", "--out", "run"]


class Odometry(unittest.TestCase):
    def of(self, values):
        with tempfile.TemporaryDirectory() as folder:
            config = pathlib.Path(folder) / "config.yaml"
            config.write_text(values, encoding="ascii")
            return slam_run.has_own_odometry(config)

    def test_of_a_run_is_its_own_where_more_than_the_wheels_tell_it(self):
        self.assertFalse(self.of("odometry: wheel\nlibraries: []\n"))
        self.assertTrue(self.of("odometry: visual\n"))
        self.assertTrue(self.of("odometry: visual_wheel\n"))
        self.assertFalse(self.of("odometry: none\n"))


class Origin(unittest.TestCase):
    def command(self, **environment):
        with unittest.mock.patch.dict(os.environ, environment):
            if not environment:
                os.environ.pop("SLAM_COMMAND", None)
            arguments = slam_run.parse_arguments(REQUIRED)
            return json.loads(slam_run.origin_of(arguments, REQUIRED))["command"]

    def test_names_the_command_as_it_was_called(self):
        words = " ".join(REQUIRED)
        self.assertEqual(self.command(SLAM_COMMAND="./slam"), f"./slam run {words}")
        self.assertEqual(self.command(SLAM_COMMAND="slam"), f"slam run {words}")
        self.assertEqual(self.command(), f"rosrun slam_ros slam_run {words}")


class WrongUse(unittest.TestCase):
    def refusal(self, *arguments):
        said = io.StringIO()
        with contextlib.redirect_stderr(said), self.assertRaises(SystemExit) as end:
            slam_run.parse_arguments([*REQUIRED, *arguments])
        self.assertEqual(end.exception.code, 2)
        return said.getvalue()

    def test_names_the_nearest_option(self):
        self.assertIn("did you mean --robot?", self.refusal("--robto", "mrclam"))

    def test_refuses_online_options_offline(self):
        self.assertIn("go with --online", self.refusal("--rate", "2"))
        self.assertIn("go with --online", self.refusal("--composition", "pubsub"))

    def test_refuses_to_save_a_session_online(self):
        self.assertIn("call the service save_session",
                      self.refusal("--online", "--save-session", "x.session"))

    def test_refuses_checkpoints_online(self):
        self.assertIn("go without --online", self.refusal("--online", "--autosave", "5"))

    def test_refuses_an_interval_that_is_none(self):
        self.assertIn("is no interval", self.refusal("--autosave", "nan"))
        self.assertIn("is no interval", self.refusal("--autosave=-1"))

    def test_a_run_is_begun_or_resumed(self):
        self.assertIn("not allowed with", self.refusal("--resume", "run"))

    def test_refuses_a_speed_that_is_none(self):
        self.assertIn("not a speed", self.refusal("--online", "--rate=-1"))
        self.assertIn("not a speed", self.refusal("--online", "--rate", "nan"))


class Notices(unittest.TestCase):
    def test_that_a_node_has_died_are_left_out_where_it_ended_well(self):
        rule = 80 * "="
        for cause, is_shown in (("process has finished cleanly", False),
                                ("process has died [pid 3, exit code 1]", True)):
            notice = [f"\x1b[31m{rule}REQUIRED process [a-1] has died!\n", cause + "\n",
                      "Initiating shutdown!\n", rule + "\x1b[0m\n"]
            lines = ["before\n", *notice, "after\n"]
            self.assertEqual(list(slam_run.without_good_ends(lines)),
                             lines if is_shown else ["before\n", "after\n"])
        cut = ["before\n", *notice[:2]]
        self.assertEqual(list(slam_run.without_good_ends(cut)), cut)


class Launch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        pathlib.Path("p.yaml").write_text(PRODUCT, encoding="ascii")

    def command(self, *arguments):
        options = slam_run.parse_arguments([*REQUIRED, "--online", *arguments])
        return slam_run.launch_command(options)

    def test_has_absolute_paths_and_runs_as_fast_as_it_goes(self):
        command = self.command()
        self.assertIn(f"bag:={os.getcwd()}/x.bag", command)
        self.assertIn(f"output_dir:={os.getcwd()}/run", command)
        self.assertIn("rate:=0", command)
        self.assertIn(f"product:={os.getcwd()}/p.yaml", command)

    def test_passes_on_features_as_arguments_of_their_own(self):
        command = self.command("--set", "second_detector=aruco", "second_camera=true", "ekf.gate=9")
        self.assertIn("second_detector:=aruco", command)
        self.assertIn("second_camera:=true", command)
        self.assertIn("set:=ekf.gate=9", command)

    def test_passes_on_names_that_roslaunch_cannot_carry(self):
        odd = "it's a := \"place\""
        os.mkdir(odd)
        command = slam_run.launch_command(slam_run.parse_arguments(
            ["p.yaml", "--bag", f"{odd}/x y.bag", "--out", odd, "--online", "--load-map", odd]))
        for word in command[3:]:
            self.assertEqual(word.count(":="), 1, word)
            self.assertFalse(set(word) & set("'\" "), word)
        given = dict(word.split(":=") for word in command[3:])
        uri = pathlib.Path(odd).absolute().as_uri()
        self.assertEqual((given["output_dir"], given["load_map"]), (uri, uri))
        self.assertEqual(given["bag"], uri + "/x%20y.bag")

    def test_passes_on_what_was_asked_for_without_a_colon_in_a_value(self):
        command = self.command("--set", "a.b=1", "c.d=2", "--set", "e.f=3", "--remap", "odom:=/w",
                               "--seed", "7", "--composition", "inprocess", "--rate", "3")
        for word in ("set:=a.b=1 c.d=2 e.f=3", "remap:=odom=/w", "seed:=7",
                     "composition:=inprocess", "rate:=3"):
            self.assertIn(word, command)


    def test_a_feature_that_is_set_is_an_argument_of_the_launch(self):
        command = self.command("--set", "a.b=1", "detector=aruco", "pointmap=true")
        for word in ("set:=a.b=1", "detector:=aruco", "pointmap:=true"):
            self.assertIn(word, command)


class Output(unittest.TestCase):
    def of(self, text):
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown), \
                subprocess.Popen(["printf", text], stdout=subprocess.PIPE, text=True) as process:
            output = slam_run.Output(process.stdout, sys.stdout)
            output.start()
            output.join()
        return shown.getvalue(), output.is_through

    def test_is_passed_on_and_tells_whether_the_bag_came_to_its_end(self):
        self.assertEqual(self.of("a\n[INFO] x.bag is through\nb\n"),
                         ("a\n[INFO] x.bag is through\nb\n", True))
        self.assertEqual(self.of("a\nb"), ("a\nb", False))


class InvalidProduct(unittest.TestCase):
    def test_is_refused_before_anything_starts(self):
        with tempfile.TemporaryDirectory() as folder:
            product = pathlib.Path(folder) / "p.yaml"
            product.write_text(PRODUCT.replace("ekf", "efk"), encoding="ascii")
            with self.assertRaisesRegex(slam_run.UsageError, "backend=efk.*did you mean 'ekf'"):
                slam_run.require_product(str(product))
            product.write_text(PRODUCT, encoding="ascii")
            slam_run.require_product(str(product))

    def settle(self, *arguments):
        slam_run.require_arguments(slam_run.parse_arguments(["ekf_wheel", *REQUIRED[1:],
                                                             *arguments]))

    def assert_refused(self, sentence, *arguments):
        with self.assertRaisesRegex(slam_run.UsageError, sentence):
            self.settle(*arguments)

    def test_a_run_sets_parameters_and_what_may_be_swapped(self):
        self.settle("--set", "detector=aruco", "pointmap=true", "ekf.gate_probability=0.9",
                    "frames.map=world", "--seed", "3")
        self.assert_refused("backend=pf cannot be set, since the product ekf_wheel is backend=ekf",
                            "--set", "backend=pf")
        self.assert_refused("did you mean 'aruco'", "--set", "detector=aruko")
        self.assert_refused("pf.particles is a parameter of backend=pf", "--set", "pf.particles=3")

    def test_a_run_sets_a_key_once(self):
        self.assert_refused("frames.map is set twice, to a and to b", "--set", "frames.map=a",
                            "--set", "frames.map=b")
        self.assert_refused("seed is set twice, to 3 and to 4", "--set", "seed=3", "--seed", "4")

    def test_a_map_that_is_kept_fixed_has_to_be_given(self):
        self.assert_refused("--load-map FILE", "--set", "ekf.mode=localization")
        self.settle("--set", "ekf.mode=localization", "--load-map", "map.yaml")


class Online(unittest.TestCase):
    def test_into_the_folder_of_another_run_fails_before_anything_starts(self):
        with tempfile.TemporaryDirectory() as folder:
            slam_run.require_no_other_run(folder)
            held = os.open(folder, os.O_RDONLY)
            self.addCleanup(os.close, held)
            fcntl.flock(held, fcntl.LOCK_EX)
            bag = pathlib.Path(folder) / "x.bag"
            bag.write_bytes(b"")
            (bag.parent / "config.yaml").write_text("of the other run", encoding="ascii")
            chosen = slam_run.parse_arguments([*REQUIRED[:1], "--bag", str(bag), "--out", folder,
                                               "--online"])
            with self.assertRaisesRegex(slam_run.RunError, "another run is writing"):
                slam_run.run_online(chosen, "{}")
            self.assertTrue((bag.parent / "config.yaml").exists())

    def test_of_a_bag_that_is_not_there_fails_before_anything_starts(self):
        chosen = slam_run.parse_arguments([*REQUIRED[:2], "/nowhere/x.bag", "--out", "/nowhere/run",
                                           "--online"])
        with self.assertRaisesRegex(slam_run.RunError, "there is no such file"):
            slam_run.run_online(chosen, "{}")

    def test_leaves_the_time_of_a_running_master_as_it_was(self):
        with running_master() as master:
            for before in (None, False, True):
                if before is not None:
                    master.setParam("/use_sim_time", before)
                with slam_run.kept_time():
                    master.setParam("/use_sim_time", True)
                self.assertEqual(master.hasParam("/use_sim_time"), before is not None)
                if before is not None:
                    self.assertEqual(master.getParam("/use_sim_time"), before)

    def test_needs_no_running_master(self):
        with unittest.mock.patch.dict(os.environ, ROS_MASTER_URI=f"http://localhost:{free_port()}"):
            with slam_run.kept_time():
                pass


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def running_master():
    """Starts a master; gives access to it."""
    port = free_port()
    with unittest.mock.patch.dict(os.environ, ROS_MASTER_URI=f"http://localhost:{port}"):
        process = subprocess.Popen(["rosmaster", "--core", "-p", str(port)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            master = rosgraph.Master("/test")
            while not master.is_online():
                time.sleep(0.05)
            yield master
        finally:
            process.terminate()
            process.wait()


if __name__ == "__main__":
    unittest.main()
