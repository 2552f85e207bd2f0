# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drift over pieces of the way, as odometry is compared (Geiger et al. 2012)."""
import dataclasses

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.trajectory import interpolate

LENGTH = 2.0  # of a piece [m]


@dataclasses.dataclass(frozen=True)
class Drift:
    """Mean errors of all pieces, relative to their way."""

    translation: float         # [1]
    rotation_rad_per_m: float
    pieces: int


def segment_drift(trajectory, truth, length=LENGTH):
    """Drift over all pieces of the true way that are `length` [m] long, or None without any.

    Pieces begin at every pose that has truth and end at the first pose after that way. Truth
    without headings tells none.
    """
    if not truth.has_heading:
        return None
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
    error = se2.relative(se2.relative(true[starts], true[ends]),
                         se2.relative(poses[starts], poses[ends]))
    done = way[ends] - way[starts]
    return Drift(float(np.mean(np.linalg.norm(error[:, :2], axis=1) / done)),
                 float(np.mean(np.abs(error[:, 2]) / done)), len(starts))
