# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a laser says."""
import dataclasses

import numpy as np

from slam_doctor.record.thinned import Blocks, Thinned

MOST_BEAMS = 720  # kept of a scan


@dataclasses.dataclass(frozen=True)
class Geometry:
    """The angles [rad] and ranges [m] that a scan's header names."""

    angle_min: float
    angle_max: float
    increment: float
    range_min: float
    range_max: float
    beams: int


@dataclasses.dataclass(frozen=True)
class Scan:
    """The beams of a scan that tell something: angles [rad] in the laser's frame, ranges [m]."""

    stamp: float  # [s]
    angles: np.ndarray
    ranges: np.ndarray

    def points(self):
        """The ends of the beams, N x 2 [m]."""
        return self.ranges[:, None] * np.stack([np.cos(self.angles), np.sin(self.angles)], axis=-1)


class LaserRecord:
    """The scans of one topic."""

    def __init__(self, start):
        self._start = start
        self._last = None        # (ranges, stamps of the first and the last scan that had them)
        self.count = self.constant = self.without_points = 0
        self.frames = set()
        self.geometries = {}     # how many scans have which
        self.usable = Thinned()  # share of the beams of a scan
        self._repeats = Thinned()
        self.blocks = Blocks()

    def take(self, message):
        """Takes a message."""
        self.count += 1
        self.frames.add(message.header.frame_id.lstrip("/"))
        geometry = Geometry(message.angle_min, message.angle_max, message.angle_increment,
                            message.range_min, message.range_max, len(message.ranges))
        if geometry in self.geometries or len(self.geometries) < 100:
            self.geometries[geometry] = self.geometries.get(geometry, 0) + 1
        stamp = (message.header.stamp.to_nsec() - self._start) / 1e9
        ranges = np.array(message.ranges, dtype=np.float32)
        self._look_for_repeats(stamp, ranges)
        self._add_scan(stamp, ranges, geometry)

    def _look_for_repeats(self, stamp, ranges):
        if self._last is not None and np.array_equal(ranges, self._last[0], equal_nan=True):
            self._last = (ranges, self._last[1], stamp)
            return
        self._end_repeat()
        self._last = (ranges, stamp, stamp)

    def _end_repeat(self):
        if self._last is not None and self._last[2] > self._last[1]:
            self._repeats.append(self._last[1:])

    def repeats(self):
        """(stamp of the first, of the last) of scans with the same ranges [s]."""
        is_open = self._last is not None and self._last[2] > self._last[1]
        return self._repeats.items + ([self._last[1:]] if is_open else [])

    def _add_scan(self, stamp, ranges, geometry):
        with np.errstate(invalid="ignore"):
            is_usable = np.isfinite(ranges) & (ranges > max(geometry.range_min, 1e-3)) & \
                (ranges < geometry.range_max)
        count = int(is_usable.sum())
        self.usable.append(count / len(ranges) if len(ranges) else 0.0)
        self.without_points += count == 0
        self.constant += count > 10 and float(np.ptp(ranges[is_usable])) < 1e-4
        every = max(1, -(-len(ranges) // MOST_BEAMS))
        at = np.flatnonzero(is_usable[::every]) * every
        angles = (geometry.angle_min + geometry.increment * at).astype(np.float32)
        self.blocks.append(Scan(stamp, angles, ranges[at]))

    def geometry(self):
        """That of most scans."""
        return max(self.geometries, key=self.geometries.get)
