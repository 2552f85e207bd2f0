# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pairs of scans between which odometry says that the robot drove straight, turned, or stood."""
import dataclasses

import numpy as np

from slam_doctor.scans.match import FAR, Reference

STRAIGHT = 0.3        # most turn of a drive [rad]
DRIVE = (0.25, 1.3)   # its way [m]
TURN = (0.12, 0.55)   # turn of a turn [rad]
NEAR = 0.35           # its way at most [m]
STAND = 1.0           # for how long a pair stands [s]
MOST_PAIRS = 60       # of a kind
FEWEST_POINTS = 30    # of a scan that is used


@dataclasses.dataclass(frozen=True)
class Pair:
    """Two scans as points in the robot's frame, and odometry's motion between them."""

    begin: float        # stamps [s]
    end: float
    first: np.ndarray   # N x 2 [m]
    second: np.ndarray
    odometry: np.ndarray  # x, y [m], turn [rad]


class ScansInBase:
    """The kept runs of a laser's scans with the odometry at their stamps. mount: the laser's pose
    in the robot's base frame, 4 x 4."""

    def __init__(self, record, path, mount):
        self._path, self._mount = path, mount
        self.runs = [self._usable(run) for run in record.blocks.runs()]

    def _usable(self, run):
        stamps = np.array([scan.stamp for scan in run])
        known = np.isfinite(self._path.poses(stamps)[:, 0])
        enough = np.array([len(scan.ranges) >= FEWEST_POINTS for scan in run])
        return [scan for scan, use in zip(run, known & enough) if use]

    def points(self, scan):
        """A scan's points in the robot's frame, N x 2 [m]; those that are far are left out."""
        points = scan.points()[scan.ranges < FAR]
        return points @ self._mount[:2, :2].T + self._mount[:2, 3]

    def pair(self, first, second):
        """The Pair of two scans."""
        return Pair(first.stamp, second.stamp, self.points(first), self.points(second),
                    self._path.motion(first.stamp, second.stamp))

    def _spread(self, found):
        at = np.linspace(0, len(found) - 1, min(MOST_PAIRS, len(found))).astype(int)
        pairs = [self.pair(*found[i]) for i in at]
        return [pair for pair in pairs
                if min(len(pair.first), len(pair.second)) >= FEWEST_POINTS]

    def drives(self):
        """Pairs with a drive that is nearly straight between them."""
        return self._spread([hit for run in self.runs for hit in self._search(run, is_drive)])

    def turns(self):
        """Pairs with a turn between them and little way."""
        return self._spread([hit for run in self.runs for hit in self._search(run, is_turn)])

    def stands(self):
        """Pairs of scans between which odometry did not move, STAND apart."""
        found = [hit for run in self.runs for hit in self._stands_of(run)]
        return self._spread(found)

    def _stands_of(self, run):
        poses = self._path.poses(np.array([scan.stamp for scan in run]))
        begin = 0
        for i, scan in enumerate(run):
            if np.abs(poses[i] - poses[begin]).max() > 1e-3:
                begin = i
            elif scan.stamp - run[begin].stamp > STAND:
                yield run[begin], scan
                begin = i

    def spans(self, shortest, longest):
        """(first, second) with the shortest allowed time between them [s], from each scan on."""
        found = []
        for run in self.runs:
            stamps = np.array([scan.stamp for scan in run])
            for i, j in enumerate(np.searchsorted(stamps, stamps + shortest)):
                if j < len(run) and stamps[j] - stamps[i] <= longest:
                    found.append((run[i], run[j]))
        return found

    def _search(self, run, fits):
        """From each scan the first later one between which odometry has moved as is wanted."""
        if len(run) < 2:
            return
        poses = self._path.poses(np.array([scan.stamp for scan in run]))
        way = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(poses[:, :2], axis=0).T))])
        begin = 0
        while begin < len(run) - 1:
            moved = way[begin + 1:] - way[begin]
            turned = np.abs(poses[begin + 1:, 2] - poses[begin, 2])
            hits = np.flatnonzero(fits(moved, turned))
            if not len(hits):
                begin += 1
                continue
            yield run[begin], run[begin + 1 + hits[0]]
            begin += 1 + int(hits[0])


def is_drive(way, turn):
    """Which ways and turns are drives that are nearly straight."""
    return (way > DRIVE[0]) & (way < DRIVE[1]) & (turn < STRAIGHT)


def is_turn(way, turn):
    """Which ways and turns are turns nearly on the spot."""
    return (turn > TURN[0]) & (turn < TURN[1]) & (way < NEAR)


def match(pair, guesses):
    """The best match of a pair from some guesses of its motion."""
    return Reference(pair.first).best(pair.second, guesses)
