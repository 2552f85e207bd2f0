# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Odometry and observations of landmarks as a rawlog for MRPT's programs.

The layout of the objects is that of MRPT 2.5: an object begins with 0x80 + the length of its
class's name, the name and a version byte, and ends with 0x88. Numbers are little-endian.
"""
import dataclasses
import gzip
import math
import struct

import numpy as np

_END = b"\x88"
_EVERYWHERE = math.pi  # [rad], field of view
_SAMPLES = 300  # of a motion model that is not used


@dataclasses.dataclass(frozen=True)
class MotionNoise:
    """Standard deviations of a step by MRPT's Gaussian model: along the way [m/m], by the turn
    [m/rad], of the heading by the way [rad/m] and by the turn [rad/rad], and at least [m],
    [rad]."""

    way: float
    way_by_turn: float
    heading_by_way: float
    turn: float
    least: float
    least_heading: float


@dataclasses.dataclass(frozen=True)
class Observations:
    """What a sensor at a pose (x [m], y [m], yaw [rad]) of the robot sees at a stamp: ids, ranges
    [m] and bearings [rad], and the standard deviations of both where they are known."""

    stamp: int
    sensor: tuple
    ids: list
    ranges: list
    bearings: list
    sigmas: list = dataclasses.field(default_factory=list)


def _object(name, version, content):
    return bytes([0x80 + len(name)]) + name.encode("ascii") + bytes([version]) + content + _END


def _action(increment, noise):
    """A CActionCollection of one CActionRobotMovement2D from odometry."""
    pose = _object("CPose2D", 1, struct.pack("<3d", *increment))
    gaussian = struct.pack("<i6f", 0, *dataclasses.astuple(noise))
    samples = struct.pack("<I6f", _SAMPLES, *[0.0] * 6)
    nothing = struct.pack("<??Q", False, False, 0)  # velocities, encoders, time
    motion = _object("CActionRobotMovement2D", 7,
                     struct.pack("<i", 0) + pose + gaussian + samples + nothing)
    return _object("CActionCollection", 0, struct.pack("<I", 1) + motion)


def _frame(seen, sigmas, reach):
    """A CSensoryFrame of one CObservationBearingRange."""
    x, y, yaw = seen.sensor
    pose = _object("CPose3D", 2, struct.pack("<7d", x, y, 0.0, math.cos(yaw / 2), 0.0, 0.0,
                                             math.sin(yaw / 2)))
    content = struct.pack("<4f", 0.0, reach, 2 * _EVERYWHERE, _EVERYWHERE) + pose
    content += struct.pack("<Q?3fI", 0, False, *sigmas, 0.0, len(seen.ids))
    for identity, distance, bearing in zip(seen.ids, seen.ranges, seen.bearings):
        content += struct.pack("<3fi", distance, bearing, 0.0, identity)
    observation = _object("CObservationBearingRange", 3, content + struct.pack("<I", 0))
    return _object("CSensoryFrame", 2, struct.pack("<I", 1) + observation)


def write_rawlog(path, increments, observations, noise, sigmas):
    """Pairs of motion up to, and observations at each stamp. increments (N x 3) [m], [rad]; sigmas
    of range [m] and bearing [rad]."""
    reach = float(np.max([r for seen in observations for r in seen.ranges], initial=1.0)) + 1.0
    with open(path, "wb") as file, gzip.GzipFile("", "wb", 6, file, mtime=0) as stream:
        for increment, seen in zip(increments, observations):
            stream.write(_action(increment, noise))
            stream.write(_frame(seen, sigmas, reach))
