# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What happens to robots, put into the bag of a drive: people walk by, and the robot is carried away
while its odometry stands still. edit() takes any change of messages."""
import dataclasses
import math
import random
import struct

import genpy
import numpy as np
import rosbag

ODOMETRY, SCAN, POSE = "nav_msgs/Odometry", "sensor_msgs/LaserScan", "geometry_msgs/PoseStamped"
OBSERVATIONS = "slam_msgs/LandmarkObservationArray"
# These messages are cut out with the drive, and later ones get earlier stamps; a header comes first.
STAMPED = (ODOMETRY, SCAN, POSE, OBSERVATIONS, "sensor_msgs/Image", "sensor_msgs/CompressedImage",
           "sensor_msgs/CameraInfo", "sensor_msgs/Imu")
_STAMP, _STAMP_AT = struct.Struct("<II"), 4
_PLACE = struct.Struct("<7d")
_LASER = struct.Struct("<7fI")  # angle_min, angle_max, its step, times, ranges, their number

LEG, STRIDE = 0.08, 0.15  # radius of a leg, and of the two from the middle of a person [m]


def compose(a, b):
    """The pose (x, y, theta) b seen from a."""
    cosine, sine = math.cos(a[2]), math.sin(a[2])
    return (a[0] + cosine * b[0] - sine * b[1], a[1] + sine * b[0] + cosine * b[1], a[2] + b[2])


def inverse(a):
    """The pose that composed with a is none."""
    cosine, sine = math.cos(a[2]), math.sin(a[2])
    return (-cosine * a[0] - sine * a[1], sine * a[0] - cosine * a[1], -a[2])


def _after_string(raw, at):
    return at + 4 + struct.unpack_from("<I", raw, at)[0]


def _place_at(kind, raw):
    at = _after_string(raw, 12)
    return _after_string(raw, at) if kind == ODOMETRY else at


def read_place(kind, raw):
    """The pose (x, y, theta) of a message of ODOMETRY or POSE."""
    x, y, _, _, _, c, d = _PLACE.unpack_from(raw, _place_at(kind, raw))
    return x, y, 2.0 * math.atan2(c, d)


def write_place(kind, raw, place):
    """Sets the pose in a message."""
    x, y, theta = place
    _PLACE.pack_into(raw, _place_at(kind, raw), x, y, 0.0, 0.0, 0.0, math.sin(theta / 2),
                     math.cos(theta / 2))


@dataclasses.dataclass
class Person:
    """Walks straight on for some time, past the robot. In the odometry's frame, [m] and [s]."""

    start: float
    end: float
    place: tuple
    velocity: tuple

    def legs(self, time):
        """The middles of both legs."""
        swing = STRIDE * math.sin(6.0 * time)
        speed = max(0.1, math.hypot(*self.velocity))
        ahead = [v / speed for v in self.velocity]
        middle = [p + v * (time - self.start) for p, v in zip(self.place, self.velocity)]
        across = (-ahead[1], ahead[0])
        return [[m + side * (0.12 * c + swing * a) for m, c, a in zip(middle, across, ahead)]
                for side in (-1, 1)]


class People:
    """They come now and then, and hide what is behind them."""

    def __init__(self, seed, every):
        self._chance, self._every = random.Random(seed), every
        self._next, self._present = self._chance.expovariate(1.0 / every), []

    def _come(self, time, robot):
        bearing = self._chance.uniform(-math.pi, math.pi)
        place = compose((robot[0], robot[1], bearing), (2.0, self._chance.uniform(-0.8, 0.8), 0.0))
        speed = self._chance.uniform(0.2, 1.2)
        heading = bearing + math.pi
        self._present.append(Person(time, time + 4.0 / speed, place[:2], (
            speed * math.cos(heading), speed * math.sin(heading))))
        self._next = time + self._chance.expovariate(1.0 / self._every)

    def hide(self, time, robot, raw):
        """Shorten the beams of a scan that meet a leg."""
        while time > self._next:
            self._come(time, robot)
        self._present = [person for person in self._present if person.end > time]
        if not self._present:
            return
        at = _after_string(raw, 12)
        first, _, step, *_, count = _LASER.unpack_from(raw, at)
        ranges = np.frombuffer(raw, "<f4", count, at + _LASER.size)
        bearings = first + step * np.arange(count)
        origin = inverse(robot)
        for person in self._present:
            for leg in person.legs(time):
                x, y, _ = compose(origin, (*leg, 0.0))
                distance = math.hypot(x, y)
                if distance < 0.3:
                    continue
                off = np.remainder(bearings - math.atan2(y, x) + math.pi, 2 * math.pi) - math.pi
                met = np.abs(off) < math.asin(min(1.0, LEG / distance))
                ranges[met] = np.minimum(np.where(np.isfinite(ranges[met]), ranges[met], 1e9),
                                         distance - LEG)


@dataclasses.dataclass(frozen=True)
class Carried:
    """The robot's drive between two times [s since the start] is cut out, odometry goes on; some
    seconds later the bag ends."""

    at: float
    until: float
    then: float = 30.0


class _Shift:
    """Takes a part out of a drive: what comes after it moves up in time, and odometry goes on."""

    def __init__(self, start, carried):
        self._carried = carried
        self._lifted = genpy.Time.from_sec(start + carried.at) if carried else None
        self._put = genpy.Time.from_sec(start + carried.until) if carried else None
        self._by, self._moved = 0, None
        self.robot = (0.0, 0.0, 0.0)

    def is_out(self, time):
        return self._carried is not None and self._lifted <= time < self._put

    def is_over(self, time):
        return self._carried is not None and (time - self._put).to_sec() > self._carried.then

    def stamp(self, raw, time):
        """Sets the stamp in the message, and returns the time of its record."""
        if self._carried and time >= self._put:
            self._by = (self._put - self._lifted).to_nsec()
        seconds, nanoseconds = _STAMP.unpack_from(raw, _STAMP_AT)
        _STAMP.pack_into(raw, _STAMP_AT, *divmod(seconds * 10**9 + nanoseconds - self._by, 10**9))
        return genpy.Time(*divmod(time.to_nsec() - self._by, 10**9))

    def move(self, raw):
        """Odometry goes on from where the robot was lifted."""
        place = read_place(ODOMETRY, raw)
        if self._by and self._moved is None:
            self._moved = compose(self.robot, inverse(place))
        self.robot = compose(self._moved, place) if self._moved else place
        write_place(ODOMETRY, raw, self.robot)


def rewrite(source, target, people=None, carried=None):
    """A bag like another one, with what happens to the robot; transforms of motion are left out."""
    with rosbag.Bag(str(source)) as bag, rosbag.Bag(str(target), "w") as out:
        start = bag.get_start_time()
        shift = _Shift(start, carried)
        for topic, (kind, raw, *rest), time in bag.read_messages(raw=True):
            if topic == "/tf":
                continue
            raw = bytearray(raw)
            if kind in STAMPED:
                if shift.is_out(time):
                    continue
                if shift.is_over(time):
                    break
                time = shift.stamp(raw, time)
            if kind == ODOMETRY:
                shift.move(raw)
            elif kind == SCAN and people:
                people.hide(time.to_sec() - start, shift.robot, raw)
            out.write(topic, (kind, bytes(raw), *rest), time, raw=True)


def edit(source, target, change, left_out=("/tf",)):
    """A bag like another one, in which change(kind, message, seconds since the start) has altered
    the messages of the types change.kinds; all others are copied byte for byte. A change may return
    by how much later the message comes [s]."""
    with rosbag.Bag(str(source)) as bag, rosbag.Bag(str(target), "w") as out:
        start = bag.get_start_time()
        for topic, raw, time in bag.read_messages(raw=True):
            if topic in left_out:
                continue
            if raw[0] not in change.kinds:
                out.write(topic, raw, time, raw=True)
                continue
            message = raw[-1]().deserialize(raw[1])
            delay = change(raw[0], message, time.to_sec() - start)
            out.write(topic, message, time + genpy.Duration.from_sec(delay or 0.0))
    return target
