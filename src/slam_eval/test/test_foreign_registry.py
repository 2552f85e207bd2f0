# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Foreign systems whose file or driver is wrong: one sentence before the start, and a failure of the
run where the driver stumbles later."""
import pathlib
import tempfile
import unittest

import run_maker  # noqa: F401, before slam_eval: it finds the source tree
from slam_eval.bench.harness.error import BenchError
from slam_eval.foreign.driver import Job
from slam_eval.foreign.registry import find_system
from slam_eval.io.errors import InputError, UsageError

SYSTEM = "version: 1\nsystem: own\ndriver: own.py:Own\nparameters: {scale: 1.0}\n"
NODE = """
version: 1
system: own
driver: slam_eval.foreign.ros_node:RosNode
parameters:
  launch: own.launch
  map_frame: map
  odom_frame: odom
  topics: /scan
  stamps: scan
  rate: 1
  arg.seed: "{seed}"
"""
DRIVER = """
import pathlib
from slam_eval.foreign.driver import Driver
from slam_eval.io.errors import InputError


class Own(Driver):
    numbers = ("scale",)

    def programs(self):
        return PROGRAMS

    def run(self, job):
        RUN
"""


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = self.folder / "own.yaml"
        (self.folder / "own.launch").write_text("<launch/>", encoding="utf-8")

    def write(self, programs="[]", run="pass", system=SYSTEM):
        self.path.write_text(system, encoding="utf-8")
        (self.folder / "own.py").write_text(
            DRIVER.replace("PROGRAMS", programs).replace("RUN", run), encoding="utf-8")

    def refuses(self, *parts, settings=()):
        with self.assertRaises(UsageError) as caught:
            find_system(str(self.path), "some.yaml").require_settings(settings, "some.yaml")
        sentence = str(caught.exception)
        self.assertNotIn("\n", sentence)
        for part in parts:
            self.assertIn(part, sentence)


class Drivers(InFolder):
    def test_that_are_no_python_are_refused(self):
        self.write()
        (self.folder / "own.py").write_text("class Own(:\n", encoding="utf-8")
        self.refuses("own.py cannot be imported", "SyntaxError", "line 1")
        (self.folder / "own.py").write_text("1 / 0\n", encoding="utf-8")
        self.refuses("own.py cannot be imported", "ZeroDivisionError")

    def test_that_are_no_drivers_are_refused(self):
        for text in ("Own = 3\n", "class Own:\n    pass\n"):
            self.write()
            (self.folder / "own.py").write_text(text, encoding="utf-8")
            self.refuses("own.py has no class 'Own' that is a Driver")

    def test_that_stumble_before_the_start_are_refused(self):
        self.write(programs="[self.parameters['nothing']]")
        self.refuses("own cannot be run", "own.py fails", "KeyError", "nothing")
        for programs in ("None", "[3]"):
            self.write(programs=programs)
            self.refuses("own cannot be run", "own.py fails", "TypeError")

    def test_check_their_parameters(self):
        self.write()
        self.refuses("the parameter scale is 'much', which is no number",
                     settings=("scale=much",))
        self.refuses("the parameter scale is 'nan'", settings=("scale=nan",))
        find_system(str(self.path), "").require_settings(("scale=2",), "some.yaml")


class Runs(InFolder):
    def run_it(self):
        find_system(str(self.path), "").run(Job("a.bag", self.folder, 1, None, (), None))

    def test_fail_with_type_and_text_of_what_a_driver_raises(self):
        self.write(run="return {}[\n            'key']")
        with self.assertRaisesRegex(BenchError, r"the driver of own failed \(KeyError: 'key'\)"):
            self.run_it()
        self.assertIn("KeyError", (self.folder / "driver.txt").read_text(encoding="utf-8"))

    def test_fail_with_the_sentence_where_there_is_one(self):
        self.write(run="raise InputError('no scan in it')")
        with self.assertRaisesRegex(InputError, "^no scan in it$"):
            self.run_it()
        self.assertFalse((self.folder / "driver.txt").exists())


class Nodes(InFolder):
    def test_need_their_parameters(self):
        for name in ("launch", "map_frame", "odom_frame", "topics", "stamps"):
            self.write(system="\n".join(line for line in NODE.split("\n")
                                        if not line.startswith(f"  {name}:")))
            self.refuses(f"own cannot be run: the parameter {name} has no value")
        self.write(system=NODE.replace("rate: 1", "rate: fast"))
        self.refuses("the parameter rate is 'fast', which is no number")

    def test_know_seed_and_robot_in_arguments_alone(self):
        for value in ("{x}", "{", "{}", "{seed.x}", "{seed[0]}"):
            self.write(system=NODE.replace("{seed}", value))
            self.refuses(f"the parameter arg.seed is '{value}'", "{seed} and {robot}")


if __name__ == "__main__":
    unittest.main()
