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
FEWEST_IN_GATE = 10  # points that make a step


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
    """Points (N x 2) placed by a motion (x, y, turn), or by each of several (M x 3): M x N x 2."""
    motion = np.asarray(motion, dtype=float)
    c, s = np.cos(motion[..., 2]), np.sin(motion[..., 2])
    turned = np.stack([np.stack([c, s], axis=-1), np.stack([-s, c], axis=-1)], axis=-2)
    return points @ turned + motion[..., None, :2]


class Reference:
    """A scan that others are matched with: its points, N x 2 [m]."""

    def __init__(self, points):
        self._points = evened(points)
        self._tree = cKDTree(self._points)
        self._normals, self._has_normal = normals_of(self._points, self._tree)

    def match(self, points, guess):
        """The Match of another scan's points from a first guess of the motion."""
        return self.matches(points, [guess])[0]

    def matches(self, points, guesses):
        """The Match from each of several guesses; all of them advance together, which is faster."""
        points = thin(points)
        motions = np.array(guesses, dtype=float)
        for gate in GATES:
            steps = self._steps(motions, points, gate)
            motions += steps
            if np.abs(steps).max() < 1e-5 and gate == GATES[-1]:
                break
        distances, at = self._tree.query(moved(motions, points))
        fits = (distances < FIT) & self._has_normal[at]
        return [Match(motions[k], float((distances[k] < FIT).mean()),
                      float(np.minimum(distances[k], GATES[0]).mean()),
                      self._normals[at[k][fits[k]]]) for k in range(len(motions))]

    def best(self, points, guesses):
        """The best of the Matches from several guesses."""
        return min(self.matches(points, guesses), key=lambda m: m.error)

    def clear_best(self, points, guesses):
        """The same; None where another place fits nearly as well, as along a corridor."""
        found = self.matches(points, guesses)
        best = min(found, key=lambda m: m.error)
        distance, factor, more = AMBIGUOUS
        rivals = [m for m in found if np.abs(m.motion - best.motion).max() > distance and
                  m.error < factor * best.error + more]
        return None if rivals else best

    def nearest(self, points):
        """For each point of another scan the distance [m] and number of the nearest point here."""
        return self._tree.query(points)

    def _steps(self, motions, points, gate):
        """The Gauss-Newton step of each motion, M x 3; zero where too few points are in the gate."""
        placed = moved(motions, points)
        distances, at = self._tree.query(placed, distance_upper_bound=gate)
        near = np.isfinite(distances)
        at[~near] = 0  # any point, as it gets no weight
        chosen = near & self._has_normal[at]
        normals = self._normals[at]
        e = np.sum(normals * (placed - self._points[at]), axis=-1)
        levers = placed - motions[:, None, :2]  # d(T q)/d(turn), turned by a right angle
        turn = normals[..., 1] * levers[..., 0] - normals[..., 0] * levers[..., 1]
        jacobian = np.concatenate([normals, turn[..., None]], axis=-1)
        weights = chosen / (1.0 + (e / LOSS) ** 2)
        weighted = (jacobian * weights[..., None]).swapaxes(1, 2)
        # Parameters that the lines do not determine keep their first guess.
        h = weighted @ jacobian + np.diag([0.05, 0.05, 0.05])
        steps = -np.linalg.solve(h, weighted @ e[..., None])[..., 0]
        enough = chosen.sum(axis=1) >= FEWEST_IN_GATE
        return np.clip(steps, -0.3, 0.3) * enough[:, None]


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
