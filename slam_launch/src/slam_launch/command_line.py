# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands that people call, in messages, and the command line of the roslaunch that asks:
roslaunch itself passes over an argument that no file has, so that a misspelt one would silently do
nothing."""

import os
import pathlib
import xml.etree.ElementTree as ElementTree

from . import packages
from .errors import did_you_mean, ProductError

FILE = "slam.launch"


def command(name):
    """Returns what people call for a program of this package: by `./slam` of a clone or the installed
    `slam`, which say so in the environment, where the caller used that, else by rosrun."""
    front_door = os.environ.get("SLAM_COMMAND")
    return f"{front_door} {name}" if front_door else f"rosrun slam_launch {name}"


def of_caller():
    """Returns the words of the process that has called this one; none where nobody tells them."""
    try:
        line = pathlib.Path(f"/proc/{os.getppid()}/cmdline").read_bytes()
    except OSError:
        return []
    return line.decode(errors="replace").split("\0")


def require_known_arguments(words):
    """Refuses NAME:=VALUE that slam.launch does not have, where it is what roslaunch was called
    with: the arguments of a file that includes it are that file's own."""
    path = packages.share() / "launch" / FILE
    if not is_called(path, words):
        return
    known = [entry.get("name") for entry in ElementTree.parse(path).getroot().iter("arg")]
    for word in words:
        name, given, _ = word.partition(":=")
        if given and name not in known and not name.startswith("_"):  # __ns:= is ROS's own
            raise ProductError(f"there is no argument '{name}'{did_you_mean(name, known)}; "
                               f"'roslaunch slam_launch {FILE} --ros-args' lists those there are")


def is_called(path, words):
    """Whether a command line names this launch file, and no other."""
    files = [number for number, word in enumerate(words)
             if word.endswith(".launch") and ":=" not in word]
    if len(files) != 1:
        return False
    package, name = words[files[0] - 1], words[files[0]]
    return (package, name) == ("slam_launch", FILE) or \
        os.path.exists(name) and os.path.samefile(name, path)
