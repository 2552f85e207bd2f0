# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program slam_doctor."""
import argparse
import difflib
import sys

from slam_doctor.case import Case
from slam_doctor.checks import agreement, camera, frames, imu, laser, machine, markers, odometry
from slam_doctor.checks import observations, timing, topics
from slam_doctor.errors import InputError, UsageError
from slam_doctor.expectations import (all_products, Expectations, NO_ROBOT, read_product,
                                       read_robot, Robot)
from slam_doctor.finding import Level
from slam_doctor.report import json_file, text

DESCRIPTION = "Checks a bag or a running robot for what makes SLAM fail, and says what to do."
EPILOG = "Exit codes: 0 no ERROR, 1 an ERROR or a bag that cannot be read, 2 wrong use."
LIVE = "live"
GROUPS = {"Inputs": [topics], "Times": [timing], "Frames and mounts": [frames],
          "Odometry": [odometry], "IMU": [imu], "Laser": [laser],
          "Laser against odometry": [agreement],
          "Cameras and landmarks": [camera, markers, observations], "Computer": [machine]}


class Parser(argparse.ArgumentParser):
    """Names the nearest option for a misspelt one."""

    def error(self, message):
        words = [word.split("=")[0] for word in message.split() if word.startswith("--")]
        options = [option for action in self._actions for option in action.option_strings]
        near = [hit for word in words if word not in options
                for hit in difflib.get_close_matches(word, options, 1)]
        super().error(message + (f" (did you mean {near[0]}?)" if near else ""))


def seconds(word):
    """A time to listen, as an argument."""
    value = float(word)
    if not 0 < value <= 3600:
        raise argparse.ArgumentTypeError(f"{word} is not between 0 and 3600 s")
    return value


def parse_arguments(arguments):
    """The arguments of a call."""
    parser = Parser(prog="slam_doctor", description=DESCRIPTION, epilog=EPILOG)
    parser.add_argument("source", metavar="BAG|live", help="a bag, or the robot that is running")
    parser.add_argument("--robot", metavar="NAME|FILE",
                        help="robot file to check against; default: the one that the bag names")
    parser.add_argument("--product", metavar="NAME|FILE",
                        help="check only what this product needs; default: all that is there")
    parser.add_argument("--seconds", type=seconds, default=10.0, metavar="S",
                        help="for how long to listen, live; default: %(default)g")
    parser.add_argument("--json", metavar="FILE", help="write the findings for scripts")
    parser.add_argument("--plot", metavar="FILE.png",
                        help="write a picture: messages over time, odometry, two scans")
    return parser.parse_args(arguments)


def record(chosen):
    """The Recording of what was named."""
    if chosen.source == LIVE:
        from slam_doctor.record.live import listen  # rospy only where it is needed
        return listen(chosen.seconds)
    from slam_doctor.record.bag import read_bag
    return read_bag(chosen.source)


def expect(chosen):
    """(Robot or None, Product or None), read before the bag, which may take long."""
    return (read_robot(chosen.robot) if chosen.robot else None,
            read_product(chosen.product) if chosen.product else None)


def robot_of(recording):
    """The Robot that the bag names; none where there is no such file."""
    if not recording.robot:
        return NO_ROBOT
    try:
        return read_robot(recording.robot)
    except UsageError as fault:
        return Robot("", {}, f"the bag names the robot {recording.robot}: {fault}")


def make_case(chosen):
    """The Case of a call."""
    robot, product = expect(chosen)
    recording = record(chosen)
    known = (product,) if product else tuple(all_products())
    return Case(recording, Expectations(robot or robot_of(recording), product, known))


def examine(case):
    """{title: [Finding]} of all checks."""
    with_numpy_quiet()
    return {title: [finding for module in modules for finding in module.check(case)]
            for title, modules in GROUPS.items()}


def with_numpy_quiet():
    """Damaged numbers are findings, not warnings of numpy."""
    import numpy
    numpy.seterr(all="ignore")


def run(chosen):
    """Does what the arguments say; returns the exit code."""
    case = make_case(chosen)
    groups = examine(case)
    print(text.text(groups, sys.stdout.isatty()))
    if chosen.json:
        json_file.write(chosen.json, json_file.as_data(case.recording.name,
                                                       case.recording.duration(), groups))
    if chosen.plot:
        from slam_doctor.report import plot  # matplotlib takes a second
        plot.draw(case, chosen.plot)
    levels = [finding.level for findings in groups.values() for finding in findings]
    return 1 if Level.ERROR in levels else 0


def main(arguments):
    """Returns the exit code of a call."""
    try:
        return run(parse_arguments(arguments))
    except UsageError as fault:
        print(f"slam_doctor: {fault}", file=sys.stderr)
        return 2
    except InputError as fault:
        print(f"slam_doctor: {fault}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
