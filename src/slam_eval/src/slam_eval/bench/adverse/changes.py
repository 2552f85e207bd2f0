# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a fault makes of the messages of a drive: changes for harness.bag_edit.edit(). Each is used
for one bag; `begin` and `end` are times since the bag's start [s]."""
import math
import random

import numpy as np
import rosbag

from slam_eval.bench.harness.bag_edit import OBSERVATIONS, ODOMETRY, SCAN
from slam_eval.bench.harness.landmark_sensor import place_of, seen_from
from slam_eval.io.trajectory import interpolate


class OdometryJump:
    """A single pose of the odometry is wrong by a distance along x [m]."""

    kinds = (ODOMETRY,)

    def __init__(self, distance, begin):
        self._distance, self._begin = distance, begin

    def __call__(self, kind, message, time):
        if self._distance is not None and time >= self._begin:
            message.pose.pose.position.x += self._distance
            self._distance = None


class FalseIds:
    """A share of the observations have the id of another landmark, drawn anew for each."""

    kinds = (OBSERVATIONS,)

    def __init__(self, ids, share, seed, begin=0.0):
        self._ids, self._share, self._begin = sorted(ids), share, begin
        self._chance = random.Random(seed)

    def __call__(self, kind, message, time):
        for seen in message.observations if time >= self._begin else ():
            if self._chance.random() < self._share:
                seen.id = self._chance.choice([i for i in self._ids if i != seen.id])


class MovedLandmarks:
    """Each landmark stands a distance [m] elsewhere, in a direction of its own; the noise of the
    observations stays. truth: a Trajectory in the world's frame."""

    kinds = (OBSERVATIONS,)

    def __init__(self, truth, distance, seed, begin=0.0):
        self._truth, self._distance, self._begin = truth, distance, begin
        self._seed = seed

    def _shift(self, identity):
        angle = random.Random(f"{self._seed} {identity}").uniform(-math.pi, math.pi)
        return self._distance * np.array([math.cos(angle), math.sin(angle)])

    def __call__(self, kind, message, time):
        if time < self._begin:
            return
        (pose,), _ = interpolate(self._truth, [message.header.stamp.to_nsec()])
        for seen in message.observations:
            place = place_of(pose, seen.range, seen.bearing) + self._shift(seen.id)
            ranges, bearings = seen_from(pose, place[None, :])
            seen.range, seen.bearing = float(ranges[0]), float(bearings[0])


class FrozenLaser:
    """The laser repeats one scan for ever, with new stamps."""

    kinds = (SCAN,)

    def __init__(self, begin):
        self._begin, self._kept = begin, None

    def __call__(self, kind, message, time):
        if time < self._begin:
            return
        if self._kept is None:
            self._kept = message.ranges, message.intensities
        message.ranges, message.intensities = self._kept


class MirroredLaser:
    """The laser counts its beams from the other side."""

    kinds = (SCAN,)

    def __init__(self, begin):
        self._begin = begin

    def __call__(self, kind, message, time):
        if time >= self._begin:
            message.ranges = message.ranges[::-1]
            message.intensities = message.intensities[::-1]


class ConstantLaser:
    """All beams have one range [m]."""

    kinds = (SCAN,)

    def __init__(self, distance, begin):
        self._distance, self._begin = distance, begin

    def __call__(self, kind, message, time):
        if time >= self._begin:
            message.ranges = [self._distance] * len(message.ranges)


def ids_in(bag_file):
    """The ids of all observations in a bag."""
    with rosbag.Bag(str(bag_file)) as bag:
        return {seen.id for _, message, _ in bag.read_messages(topics=["/observations"])
                for seen in message.observations}
