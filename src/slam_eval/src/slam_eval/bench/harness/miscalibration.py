# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a robot file has wrong about wheels and sensors, as changes of messages for
bag_edit.edit(). Each is used for one bag; `begin` and `end` are times since the bag's start [s]."""
import math

import genpy
import numpy as np

from slam_eval.bench.harness.bag_edit import (compose, inverse, OBSERVATIONS, ODOMETRY, SCAN)


def _place(message):
    pose = message.pose.pose
    return pose.position.x, pose.position.y, 2.0 * math.atan2(pose.orientation.z,
                                                              pose.orientation.w)


def _set_place(message, place):
    pose = message.pose.pose
    pose.position.x, pose.position.y, theta = place
    pose.orientation.z, pose.orientation.w = math.sin(theta / 2), math.cos(theta / 2)


def _scale_twist(message, factor):
    twist = message.twist.twist
    twist.linear.x *= factor
    twist.linear.y *= factor
    twist.angular.z *= factor


class ScaledOdometry:
    """Each increment of the odometry from `begin` to `end` is multiplied by a factor. With a factor
    of 0 the odometry stands still, and what is driven meanwhile is lost."""

    kinds = (ODOMETRY,)

    def __init__(self, factor, begin=0.0, end=math.inf):
        self._factor, self._begin, self._end = factor, begin, end
        self._before = self._out = None  # the last pose as it was, and as it was written

    def __call__(self, kind, message, time):
        place = _place(message)
        if time < self._begin or self._before is None:
            self._before = self._out = place
            if time < self._begin:
                return
        factor = self._factor if time < self._end else 1.0
        step = compose(inverse(self._before), place)
        step = (*step[:2], math.remainder(step[2], 2.0 * math.pi))
        self._out = compose(self._out, tuple(factor * x for x in step))
        self._before = place
        _set_place(message, self._out)
        _scale_twist(message, factor)


class ScaledRanges:
    """All ranges of observations and scans are multiplied by a factor; a laser's limits too."""

    kinds = (OBSERVATIONS, SCAN)

    def __init__(self, factor, begin=0.0):
        self._factor, self._begin = factor, begin

    def __call__(self, kind, message, time):
        if time < self._begin:
            return
        if kind == OBSERVATIONS:
            for seen in message.observations:
                seen.range *= self._factor
        else:
            message.ranges = (self._factor * np.array(message.ranges)).tolist()
            message.range_min *= self._factor
            message.range_max *= self._factor


class TurnedBearings:
    """All bearings, of observations and of scans, are too large by an angle [rad]."""

    kinds = (OBSERVATIONS, SCAN)

    def __init__(self, angle, begin=0.0):
        self._angle, self._begin = angle, begin

    def __call__(self, kind, message, time):
        if time < self._begin:
            return
        if kind == OBSERVATIONS:
            for seen in message.observations:
                seen.bearing = math.remainder(seen.bearing + self._angle, 2.0 * math.pi)
        else:
            message.angle_min += self._angle
            message.angle_max += self._angle


class MovedMount:
    """The messages have the sensor further ahead and further to the left than it stands [m]."""

    kinds = (OBSERVATIONS,)

    def __init__(self, ahead, left):
        self._ahead, self._left = ahead, left

    def __call__(self, kind, message, time):
        message.sensor_pose.x += self._ahead
        message.sensor_pose.y += self._left


class LateStamps:
    """Observations are stamped, and come, so much after they were made [s]."""

    kinds = (OBSERVATIONS,)

    def __init__(self, delay):
        self._delay = delay

    def __call__(self, kind, message, time):
        message.header.stamp += genpy.Duration.from_sec(self._delay)
        return self._delay


class Together:
    """Several changes, one after the other. The message comes later by the sum of their delays."""

    def __init__(self, changes):
        self._changes = list(changes)
        self.kinds = tuple({kind for change in self._changes for kind in change.kinds})

    def __call__(self, kind, message, time):
        return sum(change(kind, message, time) or 0.0
                   for change in self._changes if kind in change.kinds)
