# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A recorded drive in memory, of which parts are written as bags of their own."""
import io

import genpy
import rosbag
from slam_msgs.msg import LandmarkObservationArray

from slam_eval.bench.harness.bag_edit import (compose, inverse, OBSERVATIONS, ODOMETRY,
                                           read_place, write_place)

LATCHED = ("std_msgs/String", "tf2_msgs/TFMessage")
INPUTS = (ODOMETRY, "sensor_msgs/LaserScan", OBSERVATIONS)
TRUTH = ("geometry_msgs/PoseStamped", "slam_msgs/LandmarkMap")


class Log:
    """What a product takes in of one or several bags of the same drive.

    start, end: stamps [ns]. change(kind, raw) makes another message of one, or is None.
    """

    def __init__(self, *bags, change=None):
        self._latched, self._truth, self._inputs = [], [], []
        for path in bags:
            with rosbag.Bag(str(path)) as bag:
                for topic, raw, time in bag.read_messages(raw=True):
                    self._take(topic, raw, time, change)
        self._inputs.sort(key=lambda entry: entry[2])
        self.start, self.end = (self._inputs[i][2].to_nsec() for i in (0, -1))

    def _take(self, topic, raw, time, change):
        if raw[0] in INPUTS:
            if change is not None:
                raw = (raw[0], change(raw[0], raw[1]), *raw[2:])
            self._inputs.append((topic, raw, time))
        elif raw[0] in LATCHED and topic != "/tf":
            self._latched.append((topic, raw))
        elif raw[0] in TRUTH:
            self._truth.append((topic, raw, time))

    def write(self, target, start=None, end=None, change=None):
        """The part between two stamps [ns] as a bag; all of it, with the truth, without them."""
        first = genpy.Time(*divmod(self.start if start is None else start, 10**9))
        last = genpy.Time(*divmod(self.end if end is None else end, 10**9))
        with rosbag.Bag(str(target), "w") as out:
            for topic, raw in self._latched:
                out.write(topic, raw, first, raw=True)
            for topic, raw, time in self._truth if start is None else ():
                out.write(topic, raw, time, raw=True)
            for topic, raw, time in self._inputs:
                if first <= time <= last:
                    if change is not None:
                        raw = (raw[0], change(raw[0], raw[1], time.to_nsec()), *raw[2:])
                    out.write(topic, raw, time, raw=True)
        return target

    def observations(self):
        """(stamp [ns], ids) of each array of observations, in the order of their stamps."""
        arrays = []
        for _, raw, _ in self._inputs:
            if raw[0] == OBSERVATIONS:
                message = raw[-1]().deserialize(raw[1])
                arrays.append((message.header.stamp.to_nsec(),
                               [z.id for z in message.observations]))
        return arrays


class Slip:
    """Wheels that slip at a stamp [ns]: odometry turns [rad] and goes ahead [m] where the robot does
    not. To be used for one bag."""

    def __init__(self, stamp, turn, way):
        self._stamp, self._step, self._moved = stamp, (way, 0.0, turn), None

    def __call__(self, kind, raw, stamp):
        if kind != ODOMETRY or stamp < self._stamp:
            return raw
        raw = bytearray(raw)
        place = read_place(kind, raw)
        if self._moved is None:
            self._moved = compose(compose(place, self._step), inverse(place))
        write_place(kind, raw, compose(self._moved, place))
        return bytes(raw)


def renaming(ids):
    """A change for Log: markers that have other ids. ids: the new ones by the old."""
    def change(kind, raw):
        if kind != OBSERVATIONS:
            return raw
        message = LandmarkObservationArray()
        message.deserialize(raw)
        for z in message.observations:
            z.id = ids.get(z.id, z.id)
        buffer = io.BytesIO()
        message.serialize(buffer)
        return buffer.getvalue()
    return change
