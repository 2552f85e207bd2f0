# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How well a map closes its loops, where there is no truth: against what was seen together."""
import dataclasses
import itertools
from typing import Optional

import numpy as np


@dataclasses.dataclass
class Errors:
    """Errors of distances in the map [m], of so many pairs of landmarks; None without pairs."""

    pairs: int
    rms: Optional[float] = None
    median: Optional[float] = None


@dataclasses.dataclass
class Consistency:
    """Errors of the distances of landmarks that were first seen shortly after each other (near),
    and of those that were first seen in different laps, so that a loop lies between them (seam).
    """

    near: Errors
    seam: Errors


def _first_steps(sights):
    first = {}
    for step, sight in enumerate(sights):
        for identity in sight:
            first.setdefault(identity, step)
    return first


def _seen_distances(sights):
    """Mean distance [m] of each pair of landmarks that was seen at one step."""
    sums = {}
    for sight in sights:
        for a, b in itertools.combinations(sorted(sight), 2):
            total, count = sums.get((a, b), (0.0, 0))
            distance = float(np.hypot(*np.subtract(sight[a], sight[b])))
            sums[a, b] = (total + distance, count + 1)
    return {pair: total / count for pair, (total, count) in sums.items()}


def _errors_of(differences):
    if not differences:
        return Errors(0)
    sizes = np.abs(differences)
    return Errors(len(sizes), float(np.sqrt(np.mean(sizes**2))), float(np.median(sizes)))


def consistency(sights, positions, gap):
    """The consistency of a map with what was seen.

    A distance between two landmarks that are seen at once needs no pose; one that is wrong in the
    map, though both were seen together, is a loop that was closed badly.

    sights: for each step {id: (x, y)} in the robot's frame [m].
    positions: {id: (x, y)} of the map [m].
    gap: steps between the first sights of two landmarks from which on a loop lies between them.
    """
    first, near, seam = _first_steps(sights), [], []
    for (a, b), seen in _seen_distances(sights).items():
        if a not in positions or b not in positions:
            continue
        error = float(np.hypot(*np.subtract(positions[a], positions[b]))) - seen
        (seam if abs(first[a] - first[b]) >= gap else near).append(error)
    return Consistency(_errors_of(near), _errors_of(seam))


def map_by_odometry(sights, poses):
    """The map that dead reckoning makes: each landmark where it was first seen.

    poses: one (x, y, heading) for each sight.
    """
    positions = {}
    for sight, (x, y, heading) in zip(sights, poses):
        c, s = np.cos(heading), np.sin(heading)
        for identity, (u, v) in sight.items():
            positions.setdefault(identity, (x + c * u - s * v, y + s * u + c * v))
    return positions
