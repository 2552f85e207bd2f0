# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What foreign systems are fed with, out of a bag."""
import math

import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.foreign.mrpt_rawlog import Observations
from slam_eval.io.bag import open_bag, yaw
from slam_eval.io.trajectory import Trajectory


def planar(pose):
    """x [m], y [m], heading [rad] of a geometry_msgs/Pose."""
    return pose.position.x, pose.position.y, yaw(pose.orientation)


def planar_transform(transform):
    """The same of a geometry_msgs/Transform."""
    return transform.translation.x, transform.translation.y, yaw(transform.rotation)


def robot_of(path):
    """The robot file's name in a bag's topic robot, or None. Raises InputError where it is no
    bag."""
    with open_bag(path) as bag:
        for _, message, _ in bag.read_messages(topics=["robot", "/robot"]):
            return str(message.data)
    return None


def has_topic(path, name):
    """Whether a bag has messages of a topic, with or without a slash."""
    with open_bag(path) as bag:
        return bool({name, f"/{name}"} & set(bag.get_type_and_topic_info().topics))


def messages(path, name):
    """The messages of a topic, their stamps rising: one that does not come after the last is left
    out."""
    last = -1
    with open_bag(path) as bag:
        for _, message, _ in bag.read_messages(topics=[name, f"/{name}"]):
            stamp = message.header.stamp.to_nsec()
            if stamp > last:
                last = stamp
                yield stamp, message


def read_odometry(path):
    """The poses of a bag's odom. Raises BenchError where there are none."""
    rows = [(stamp, planar(message.pose.pose)) for stamp, message in messages(path, "odom")
            if message.pose.covariance[0] >= 0.0]
    if not rows:
        raise BenchError(f"{path} has no poses in odom, which this system needs")
    stamps, poses = zip(*rows)
    return Trajectory(np.array(stamps, dtype=np.int64), np.array(poses))


def read_observations(path):
    """The arrays of a bag's observations; landmarks without an id are left out."""
    found = []
    for stamp, message in messages(path, "observations"):
        known = {each.id: each for each in message.observations if each.id >= 0}
        found.append(Observations(stamp, (message.sensor_pose.x, message.sensor_pose.y,
                                          message.sensor_pose.theta), list(known),
                                  [each.range for each in known.values()],
                                  [each.bearing for each in known.values()],
                                  [(math.sqrt(each.covariance[0]), math.sqrt(each.covariance[3]))
                                   for each in known.values() if each.covariance[0] > 0.0]))
    return found
