# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of roslaunch that slam.launch does not have."""

import subprocess
import sys
import unittest

from slam_launch import command_line, packages
from slam_launch.errors import ProductError

CALL = ["/usr/bin/python3", "/usr/bin/roslaunch", "-p", "11311"]


class CommandLine(unittest.TestCase):
    def test_a_misspelt_argument_is_named_with_the_nearest(self):
        file = str(packages.share() / "launch" / "slam.launch")
        for launch in (["slam_launch", "slam.launch"], [file]):
            with self.assertRaises(ProductError) as caught:
                command_line.require_known_arguments([*CALL, *launch, "backned:=ekf"])
            self.assertIn("there is no argument 'backned' (did you mean 'backend'?)",
                          str(caught.exception))

    def test_what_slam_launch_has_and_what_ros_has_is_taken(self):
        command_line.require_known_arguments(
            [*CALL, "slam_launch", "slam.launch", "backend:=pf", "set:=pf.size=kld",
             "remap:=odom=/wheels", "bag:=/x/y.launch", "__ns:=left", "--wait", ""])

    def test_a_file_that_includes_it_has_arguments_of_its_own(self):
        for call in ([*CALL, "mine", "robot.launch", "speed:=3"], ["python3", "test.py", "x:=1"],
                     [*CALL, "mine", "slam.launch", "speed:=3"],
                     [*CALL, "slam_launch", "slam.launch", "other.launch", "speed:=3"], []):
            command_line.require_known_arguments(call)

    def test_the_caller_s_words_are_those_of_the_parent_process(self):
        child = "from slam_launch import command_line; print(command_line.of_caller())"
        parent = "import subprocess, sys; subprocess.run([sys.executable, '-c', sys.argv[1]])"
        printed = subprocess.run([sys.executable, "-c", parent, child, "backned:=ekf"], check=True,
                                 stdout=subprocess.PIPE, text=True).stdout
        self.assertIn("'backned:=ekf'", printed)


if __name__ == "__main__":
    unittest.main()
