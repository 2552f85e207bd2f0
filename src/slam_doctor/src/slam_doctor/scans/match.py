# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point-to-line matching of two scans (Censi 2008, with the closest point by a k-d tree).

Symbols: p a point of the reference with its normal n, q a point of the scan that is matched, T the
motion (x, y, turn) that places it, e = n . (T q - p) the residual, H the information of T.
"""
import dataclasses
import math

import numpy as np
from scipy.spatial import cKDTree

MOST_POINTS = 200  # of the scan that is matched
FAR = 25.0         # beyond, neighbouring beams are too far apart for normals [m]
GATES = (0.5, 0.5, 0.4, 0.3, 0.3, 0.2, 0.2, 0.15, 0.15, 0.15, 0.15, 0.15)  # of each iteration [m]
FIT = 0.10         # a point that lies nearer than this to the reference fits [m]
CELL = 0.05        # in which the reference's points become one [m]
NEIGHBOURS = 8     # of which a line is made
FLAT = 0.1         # variance across a line over that along it, at most
# Another match so far away [m, rad] is a rival up to the best error times this, plus this [m].
AMBIGUOUS = (0.1, 1.15, 0.002)
LOSS = 0.03        # scale of the robust weight [m]


@dataclasses.dataclass(frozen=True)
class Match:
    """Where the second scan was taken, seen from the first."""

    motion: np.ndarray  # x, y [m], turn [rad]
    share: float        # of the points that fit [1]
    error: float        # mean distance of all points, each at most GATES[0] [m]
    normals: np.ndarray  # of the lines that the points met, N x 2

    def observability(self, direction):
        """How much the lines tell of a motion along an angle [rad]: 0 (a corridor) to 1."""
        if not len(self.normals):
            return 0.0
        along = self.normals @ np.array([math.cos(direction), math.sin(direction)])
        return float(np.mean(along ** 2))


def moved(motion, points):
    """Points (N x 2) placed by a motion (x, y, turn)."""
    c, s = math.cos(motion[2]), math.sin(motion[2])
    return points @ np.array([[c, s], [-s, c]]) + motion[:2]


class Reference:
    """A scan that others are matched with: its points, N x 2 [m]."""

    def __init__(self, points):
        self._points = evened(points)
        self._tree = cKDTree(self._points)
        self._normals, self._has_normal = normals_of(self._points, self._tree)

    def match(self, points, guess):
        """The Match of another scan's points from a first guess of the motion."""
        points = thin(points)
        motion = np.array(guess, dtype=float)
        for gate in GATES:
            step = self._step(motion, points, gate)
            motion += step
            if np.abs(step).max() < 1e-5 and gate == GATES[-1]:
                break
        distances, at = self._tree.query(moved(motion, points))
        fits = (distances < FIT) & self._has_normal[at]
        return Match(motion, float((distances < FIT).mean()),
                     float(np.minimum(distances, GATES[0]).mean()), self._normals[at[fits]])

    def best(self, points, guesses):
        """The best of the Matches from several guesses."""
        return min((self.match(points, guess) for guess in guesses), key=lambda m: m.error)

    def clear_best(self, points, guesses):
        """The same; None where another place fits nearly as well, as along a corridor."""
        found = [self.match(points, guess) for guess in guesses]
        best = min(found, key=lambda m: m.error)
        distance, factor, more = AMBIGUOUS
        rivals = [m for m in found if np.abs(m.motion - best.motion).max() > distance and
                  m.error < factor * best.error + more]
        return None if rivals else best

    def nearest(self, points):
        """For each point of another scan the distance [m] and number of the nearest point here."""
        return self._tree.query(points)

    def _step(self, motion, points, gate):
        placed = moved(motion, points)
        distances, at = self._tree.query(placed, distance_upper_bound=gate)
        chosen = np.isfinite(distances)
        chosen[chosen] = self._has_normal[at[chosen]]
        if chosen.sum() < 10:
            return np.zeros(3)
        normals, placed = self._normals[at[chosen]], placed[chosen]
        e = np.sum(normals * (placed - self._points[at[chosen]]), axis=1)
        levers = placed - motion[:2]  # d(T q)/d(turn), turned by a right angle
        jacobian = np.column_stack([normals, normals[:, 1] * levers[:, 0] -
                                    normals[:, 0] * levers[:, 1]])
        weights = 1.0 / (1.0 + (e / LOSS) ** 2)
        weighted = jacobian * weights[:, None]
        # Parameters that the lines do not determine keep their first guess.
        h = weighted.T @ jacobian + np.diag([0.05, 0.05, 0.05])
        return np.clip(-np.linalg.solve(h, weighted.T @ e), -0.3, 0.3)


def evened(points):
    """The means of the points in each cell of CELL: near walls have no more points than far ones,
    and the noise of their many points is averaged."""
    cells = np.floor(points / CELL).astype(np.int64)
    _, first, at, counts = np.unique(cells[:, 0] * 100_003 + cells[:, 1], return_index=True,
                                     return_inverse=True, return_counts=True)
    means = np.stack([np.bincount(at, points[:, axis]) / counts for axis in (0, 1)], axis=-1)
    return means[np.argsort(first)]


def normals_of(points, tree):
    """The unit normals of the lines through the points around each point, and which points lie on
    such a line."""
    reach = 0.15 + 0.03 * np.hypot(*points.T)
    distances, at = tree.query(points, k=min(NEIGHBOURS, len(points)))
    weights = (distances < reach[:, None]).astype(float)
    counts = weights.sum(axis=1)
    around = points[at]
    means = (weights[..., None] * around).sum(axis=1) / counts[:, None]
    offsets = (around - means[:, None]) * weights[..., None]
    moments = np.einsum("nki,nkj->nij", offsets, offsets) / counts[:, None, None]
    values, vectors = np.linalg.eigh(moments)
    has_normal = (counts >= 4) & (values[:, 0] < FLAT * values[:, 1])
    return vectors[:, :, 0], has_normal


def thin(points):
    """At most MOST_POINTS of the points, evenly."""
    return points[::max(1, -(-len(points) // MOST_POINTS))]
