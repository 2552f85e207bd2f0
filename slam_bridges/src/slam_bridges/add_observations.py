# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program add_observations: a bag with detections becomes one with observations as well."""
import argparse
import collections
import os
import pathlib
import sys

import genpy
import rosbag
from slam_launch.errors import ProductError
from slam_launch.launch_checks import robot_of_bag

from slam_bridges.account import Account
from slam_bridges.converter import Converter
from slam_bridges.detections import READERS
from slam_bridges.robot import mounts_of

DESCRIPTION = ("Copies a bag and adds to it the observations that follow from the detections of "
               "apriltag_ros or aruco_detect in it, so that products run on it without images.")
TRANSFORMS = {"tf": False, "tf_static": True}  # topic: is it static?
TRANSFORM = "tf2_msgs/TFMessage"


class InputError(Exception):
    """A bag that cannot be used; the message is a sentence for the user."""


def parse_arguments(arguments):
    """The arguments of a call."""
    parser = argparse.ArgumentParser(prog="add_observations", description=DESCRIPTION,
                                     epilog="Exit codes: 0 done, 1 it failed, 2 wrong use.")
    parser.add_argument("source", metavar="IN.bag", type=pathlib.Path)
    parser.add_argument("target", metavar="OUT.bag", type=pathlib.Path)
    parser.add_argument("--topic", help="of the detections; default: the only one that has any")
    parser.add_argument("--observations", metavar="TOPIC", default="/observations",
                        help="where the observations go; default: %(default)s")
    parser.add_argument("--robot", metavar="NAME|FILE",
                        help="robot file with frames.base and camera.sensor_pose; default: the one "
                        "that the bag names")
    return parser.parse_args(arguments)


def kinds_of(bag):
    """{topic: type of its messages}."""
    return {topic: info.msg_type for topic, info in bag.get_type_and_topic_info().topics.items()}


def find_topic(kinds, wanted):
    """The topic with detections. Raises InputError where there is none, or not one alone."""
    if wanted:
        name = next((topic for topic in kinds if topic.lstrip("/") == wanted.lstrip("/")), None)
        if name is None:
            raise InputError(f"the bag has no topic {wanted}; it has {', '.join(sorted(kinds))}")
        return name
    found = sorted(topic for topic, kind in kinds.items() if kind in READERS)
    if not found:
        raise InputError(f"the bag holds no detections: no topic carries {' or '.join(READERS)}")
    if len(found) > 1:
        raise InputError(f"several topics carry detections: choose one, --topic {found[0]} "
                         f"({', '.join(found)})")
    return found[0]


class Sums:
    """How much was added."""

    def __init__(self):
        self.arrays = self.observations = 0
        self.ids = set()

    def add(self, array):
        """Adds an array to the sums."""
        self.arrays += 1
        self.observations += len(array.observations)
        self.ids.update(z.id for z in array.observations)


def read_transforms(bag, mounts):
    """Takes all transforms of a bag, so that one that moves is known before it is used."""
    for topic, message, _ in bag.read_messages(topics=[f"/{name}" for name in TRANSFORMS] +
                                               list(TRANSFORMS)):
        if message._type == TRANSFORM:
            mounts.take(message, TRANSFORMS[topic.lstrip("/")])


def copy(bag, out, topic, name, converter, account):
    """Copies all messages and adds observations behind each of the topic; returns the Sums."""
    sums = Sums()
    for at, raw, time, header in bag.read_messages(raw=True, return_connection_header=True):
        out.write(at, raw, time, raw=True, connection_header=header)
        if at != topic:
            continue
        try:
            message = raw[-1]().deserialize(raw[1])
        except genpy.MessageException as fault:
            account.add("unreadable", kind=raw[0], topic=topic, cause=fault)
            continue
        array = converter.convert(topic, raw[0], message)
        if array is not None:
            sums.add(array)
            out.write(name, array, time)
    return sums


def add(chosen, account):
    """Writes the new bag; returns (topic, Sums). Raises InputError or ProductError."""
    mounts = mounts_of(chosen.robot or robot_of_bag(str(chosen.source)), account)
    unfinished = chosen.target.with_name(f".{chosen.target.name}.unfinished")
    try:
        with rosbag.Bag(str(chosen.source)) as bag:
            kinds = kinds_of(bag)
            topic = find_topic(kinds, chosen.topic)
            if chosen.observations in kinds:
                raise InputError(f"the bag has a topic {chosen.observations} already; name another "
                                 "with --observations")
            read_transforms(bag, mounts)
            with rosbag.Bag(str(unfinished), "w", compression=rosbag.Compression.LZ4) as out:
                sums = copy(bag, out, topic, chosen.observations, Converter(mounts, account),
                            account)
        if not sums.arrays:
            raise InputError(f"no message on {topic} could be used; {chosen.target} is not written")
        os.replace(unfinished, chosen.target)
    finally:
        unfinished.unlink(missing_ok=True)
    return topic, sums


def require_files(chosen):
    """Refuses what cannot be read or written."""
    if not chosen.source.is_file():
        raise InputError(f"there is no bag {chosen.source}")
    if chosen.target.exists() and chosen.source.samefile(chosen.target):
        raise InputError("IN.bag and OUT.bag are the same file; name another for the result")


def main(arguments):
    """Returns the exit code of a call."""
    chosen = parse_arguments(arguments)
    said = collections.Counter()

    def say(reason, sentence):
        said[reason] += 1
        if said[reason] == 1:
            print(f"warning: {sentence}", file=sys.stderr)

    account = Account(say)
    try:
        require_files(chosen)
        topic, sums = add(chosen, account)
    except (InputError, ProductError) as fault:
        print(f"add_observations: {fault}", file=sys.stderr)
        return 1
    except (OSError, rosbag.ROSBagException) as fault:
        print(f"add_observations: cannot read or write a bag: {fault}", file=sys.stderr)
        return 1
    finally:
        if account.counters:
            print("counted:", ", ".join(f"{key} {n}" for key, n in account.counters.items()))
    print(f"{chosen.target}: {sums.observations} observations of {len(sums.ids)} markers in "
          f"{sums.arrays} arrays on {chosen.observations}, made of {topic}")
    return 0
