# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How odometry compares with the scans: ratio of ways and of turns, direction, offset in time."""
import dataclasses
import math

import numpy as np

from slam_doctor.scans.match import Reference
from slam_doctor.scans.pairs import FEWEST_POINTS, match

FIT = 0.6              # share of the points that must fit for a match to count
STRAIGHT = 0.12        # most turn of a drive that tells the laser's heading [rad]
OBSERVABLE = 0.08      # of a motion's direction, at least
FEWEST = 5             # pairs that say something
WAYS = (1.0, 0.5, 0.7, 1.35, 1.8, -1.0)  # guesses of true way over odometry's
TURNS = (1.0, -1.0, 0.6, 1.5)            # of true turn over odometry's
CLEAR = 0.02           # by how much the better direction must fit better [m]
MOST_TIMED = 240       # pairs of which the offset in time is made
SPAN = (0.35, 0.8)     # time between the two scans of these, as near to the first as there are [s]
WINDOW = 1.0           # offsets that are tried, either way [s]
STEP = 0.005           # [s]
GROUPS = 6             # of pairs, whose spread tells how well the offset is known
NO_MOTION, STANDS = 0.06, 0.5  # [m]; share of the points nearer than this of a robot that stands
STAND_GUESSES = [(0, 0, 0), (0, 0, 0.25), (0, 0, -0.25), (0.3, 0, 0), (-0.3, 0, 0), (0, 0, 0.6),
                 (0, 0, -0.6), (0.8, 0, 0)]


@dataclasses.dataclass(frozen=True)
class Ratio:
    """What is seen in the scans over what odometry tells."""

    value: float  # [1]
    sigma: float  # [1]
    count: int    # of pairs


def ratio_of(values):
    """The Ratio of many single ones, by their median; None of too few."""
    if len(values) < FEWEST:
        return None
    values = np.array(values)
    median = float(np.median(values))
    spread = 1.4826 * float(np.median(np.abs(values - median)))
    return Ratio(median, math.hypot(1.25 * spread / math.sqrt(len(values)), 0.003), len(values))


@dataclasses.dataclass(frozen=True)
class Drives:
    """What straight drives say."""

    way: Ratio      # true way over odometry's
    heading: Ratio  # of the motion in the scans against odometry's [rad]


def compare_drives(pairs):
    """The Drives of pairs; None where they do not say it."""
    ratios, headings = [], []
    for pair in pairs:
        x, y, turn = pair.odometry
        found = Reference(pair.first).clear_best(pair.second, [(k * x, k * y, turn) for k in WAYS])
        direction = math.atan2(y, x)
        if found is None or found.share < FIT or found.observability(direction) < OBSERVABLE:
            continue
        cosine, sine = math.cos(direction), math.sin(direction)
        along = cosine * found.motion[0] + sine * found.motion[1]
        across = cosine * found.motion[1] - sine * found.motion[0]
        ratios.append(along / math.hypot(x, y))
        sideways = found.observability(direction + math.pi / 2)
        if abs(turn) < STRAIGHT and abs(along) > 0.1 and sideways > OBSERVABLE:
            headings.append(math.atan2(across, abs(along)) * math.copysign(1.0, along))
    way = ratio_of(ratios)
    return Drives(way, ratio_of(headings)) if way else None


@dataclasses.dataclass(frozen=True)
class Turns:
    """What turns say."""

    turn: Ratio       # true turn over odometry's, of those with the direction of most
    same: int         # how many pairs say that laser and odometry turn the same way
    opposite: int     # and the other way
    example: object   # the Pair that says it most clearly


def compare_turns(pairs):
    """The Turns of pairs; None where too few say something."""
    values, clearest = [], (0.0, None)
    for pair in pairs:
        x, y, turn = pair.odometry
        found = Reference(pair.first).matches(pair.second, [
            (x, y * math.copysign(1, k), k * turn) for k in TURNS])
        best = min(found, key=lambda m: m.error)
        ratio = best.motion[2] / turn
        other = min((m.error for m in found if m.motion[2] * ratio * turn <= 0), default=0.5)
        # Round rooms look the same after any turn.
        if best.share < FIT or abs(ratio) < 0.3 or other - best.error < CLEAR:
            continue
        values.append(ratio)
        clearest = max(clearest, (other - best.error, pair), key=lambda entry: entry[0])
    values = np.array(values)
    same, opposite = int((values > 0).sum()), int((values < 0).sum())
    ratio = ratio_of(values[values > 0] if same >= opposite else values[values < 0])
    return Turns(ratio, same, opposite, clearest[1]) if ratio else None


@dataclasses.dataclass(frozen=True)
class Offset:
    """By how much the scans' stamps are later than odometry's, for the same moment."""

    value: float  # [s]
    sigma: float  # [s]


def compare_times(scans, path, ratio=1.0):
    """The Offset between the stamps of scans (ScansInBase) and those of a Path; ratio: true turn
    over odometry's. None where the turns do not say it."""
    begins, ends, turns = timed_turns(scans, path, ratio)
    if len(turns) < 4 * GROUPS:
        return None
    offsets = np.arange(-WINDOW, WINDOW + STEP / 2, STEP)
    costs = np.stack([residuals(path, begins - o, ends - o, turns, ratio) for o in offsets])
    value = lowest(offsets, costs.mean(axis=1))
    # Groups of successive spans, as neighbours share their scans.
    groups = np.array_split(costs, GROUPS, axis=1)
    off = [abs(lowest(offsets, group.mean(axis=1)) - value) for group in groups]
    spread = 1.4826 * float(np.median(off))
    return Offset(value, max(0.002, 1.25 * spread / math.sqrt(GROUPS)))


def residuals(path, begins, ends, turns, ratio):
    """How far the turns are from odometry's between these stamps, each at most 0.1 rad."""
    told = np.interp(ends, path.stamps, path.heading) - np.interp(begins, path.stamps, path.heading)
    return np.minimum(np.abs(ratio * told - turns), 0.1)


def lowest(offsets, costs):
    """Where the costs are lowest, between the offsets by a parabola."""
    i = int(np.argmin(costs))
    if 0 < i < len(costs) - 1:
        bend = costs[i - 1] - 2 * costs[i] + costs[i + 1]
        if bend > 0:
            return float(offsets[i] + 0.5 * STEP * (costs[i - 1] - costs[i + 1]) / bend)
    return float(offsets[i])


def timed_turns(scans, path, ratio):
    """Stamps of begin and end and the turns that the scans tell, of pairs around which the turn
    rate changes most, as only these tell a time."""
    pairs = scans.spans(*SPAN)
    if not pairs:
        return np.empty(0), np.empty(0), np.empty(0)
    changes = rate_changes(path, np.array([a.stamp for a, _ in pairs]))
    chosen = np.sort(np.argsort(-changes, kind="stable")[:MOST_TIMED])
    rows = [timed_turn(scans.pair(*pairs[i]), ratio) for i in chosen if changes[i] > 0.05]
    rows = [row for row in rows if row is not None]
    return tuple(np.array(rows).reshape(-1, 3).T)


def rate_changes(path, stamps):
    """Spread of odometry's turn rate around stamps [rad/s]."""
    around = stamps[:, None] + np.linspace(-0.5, 1.0, 6)
    headings = np.interp(around, path.stamps, path.heading)
    return np.ptp(np.diff(headings, axis=1) / 0.3, axis=1)


def timed_turn(pair, ratio):
    """(begin, end, turn in the scans) of a pair, or None."""
    if min(len(pair.first), len(pair.second)) < FEWEST_POINTS:
        return None
    x, y, turn = pair.odometry
    found = match(pair, [(x, y, ratio * turn), (x, y, 0.0)])
    return (pair.begin, pair.end, found.motion[2]) if found.share >= FIT else None


@dataclasses.dataclass(frozen=True)
class Stand:
    """A time in which odometry stood still."""

    begin: float   # stamps [s]
    end: float
    motion: object  # x, y [m], turn [rad] in the scans; None where they stood still, too


def compare_stands(pairs):
    """The Stand of each pair between which odometry did not move."""
    return [Stand(pair.begin, pair.end, motion_of_stand(pair)) for pair in pairs]


def motion_of_stand(pair):
    """How the robot has moved between the scans of a pair; None where it stood, or where the scans
    do not say it: people around a robot that stands are no motion."""
    reference = Reference(pair.first)
    distances, _ = reference.nearest(pair.second)
    if (distances < NO_MOTION).mean() > STANDS:
        return None
    found = reference.best(pair.second, STAND_GUESSES)
    has_moved = math.hypot(*found.motion[:2]) > 0.1 or abs(found.motion[2]) > 0.08
    return found.motion if found.share >= FIT and has_moved else None
