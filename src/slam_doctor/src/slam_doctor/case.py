# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A recording with what it is checked against, and what several checks make of it."""
import functools
import math

import numpy as np

from slam_doctor.record.odometry import Path
from slam_doctor.scans import compare
from slam_doctor.scans.pairs import ScansInBase
from slam_doctor.sensors import find_sensors


def matrix_of(pose):
    """The 4 x 4 matrix of [x, y, z, roll, pitch, yaw]."""
    cr, cp, cy = (math.cos(angle) for angle in pose[3:])
    sr, sp, sy = (math.sin(angle) for angle in pose[3:])
    out = np.eye(4)
    out[:3, :3] = [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                   [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                   [-sp, cp * sr, cp * cr]]
    out[:3, 3] = pose[:3]
    return out


class LaserDrive:
    """What the scans of a laser show of a drive."""

    def __init__(self, case, name):
        self.case, self.name = case, name

    @functools.cached_property
    def scans(self):
        """The ScansInBase, or None. A laser without a mount is taken to sit at the base's
        origin, as directions and ways show even so."""
        record = self.case.record(self.name)
        if record is None or self.case.path is None or not record.frames:
            return None
        mount = self.case.mount(self.name, sorted(record.frames)[0])
        return ScansInBase(record, self.case.path, np.eye(4) if mount is None else mount)

    @functools.cached_property
    def drives(self):
        """compare.Drives, or None."""
        return compare.compare_drives(self.scans.drives()) if self.scans else None

    @functools.cached_property
    def turns(self):
        """compare.Turns, or None."""
        return compare.compare_turns(self.scans.turns()) if self.scans else None

    @functools.cached_property
    def offset(self):
        """compare.Offset, or None."""
        if not self.turns:
            return None
        return compare.compare_times(self.scans, self.case.path, self.turns.turn.value)


class Case:
    """What the checks look at; comparisons are made once."""

    def __init__(self, recording, expectations):
        self.recording, self.expectations = recording, expectations
        self.robot = expectations.robot
        self.sensors = find_sensors(recording, expectations)
        self._lasers = {}

    def record(self, name):
        """What the messages of an input say, or None."""
        sensor = self.sensors.get(name)
        return sensor.topic.record if sensor else None

    def cameras(self):
        """The sensors that take images."""
        return [sensor for sensor in self.sensors.values() if hasattr(sensor.topic.record,
                                                                      "measures")]

    def mount(self, name, frame):
        """The pose of a sensor's frame in the base frame, 4 x 4, or None; section `camera` or
        `laser` of the robot file counts instead of transforms."""
        section = "laser" if name == "scan" else name
        own = (self.robot.content.get(section) or {}).get("sensor_pose")
        if own and len(own) == 6:
            return matrix_of([float(value) for value in own])
        return self.recording.transforms.mount(frame, self.expectations.base())

    @functools.cached_property
    def path(self):
        """The Path of odometry; None where there is none."""
        record = self.record("odom")
        rows = record.samples() if record else []
        return Path(rows) if len(rows) > 1 else None

    def laser(self, name):
        """The LaserDrive of an input."""
        return self._lasers.setdefault(name, LaserDrive(self, name))

    @property
    def scans(self):
        """The ScansInBase of the first laser, or None."""
        return self.laser("scan").scans

    @property
    def drives(self):
        """compare.Drives of the first laser, or None."""
        return self.laser("scan").drives

    @property
    def turns(self):
        """compare.Turns of the first laser, or None."""
        return self.laser("scan").turns

    @functools.cached_property
    def stands(self):
        """A list of compare.Stand."""
        return compare.compare_stands(self.scans.stands()) if self.scans else []
