# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drift over pieces of the way, as odometry is compared (Geiger et al. 2012)."""
import dataclasses

import numpy as np

from slam_eval import se2
from slam_eval.trajectory import interpolate

LENGTH = 2.0  # of a piece [m]


@dataclasses.dataclass(frozen=True)
class Drift:
    """Mean errors of all pieces, relative to their way."""

    translation: float         # [1]
    rotation_rad_per_m: float
    pieces: int


def relative(start, end):
    """Poses (N x 3) seen from other poses (N x 3)."""
    dx, dy = (end - start)[:, 0], (end - start)[:, 1]
    c, s = np.cos(start[:, 2]), np.sin(start[:, 2])
    return np.column_stack([c * dx + s * dy, -s * dx + c * dy,
                            se2.wrap_angle(end[:, 2] - start[:, 2])])


def segment_drift(trajectory, truth, length=LENGTH):
    """Drift over all pieces of the true way that are `length` [m] long, or None without any.

    Pieces begin at every pose that has truth and end at the first pose after that way.
    """
    true, valid = interpolate(truth, trajectory.stamps)
    poses, true = trajectory.poses[valid], true[valid]
    if len(true) < 2:
        return None
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(true[:, :2], axis=0), axis=1)))
    ends = np.searchsorted(way, way + length)
    starts = np.flatnonzero(ends < len(way))
    if not len(starts):
        return None
    ends = ends[starts]
    error = relative(relative(true[starts], true[ends]), relative(poses[starts], poses[ends]))
    done = way[ends] - way[starts]
    return Drift(float(np.mean(np.linalg.norm(error[:, :2], axis=1) / done)),
                 float(np.mean(np.abs(error[:, 2]) / done)), len(starts))
