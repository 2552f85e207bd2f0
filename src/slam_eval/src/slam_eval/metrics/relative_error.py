# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relative pose error (Sturm et al. 2012, section IV.B): how far the motion between two poses is
from the true one. It needs no alignment, and a drift of long ago does not count again."""
import dataclasses

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.trajectory import interpolate, NANOSECONDS

SECOND, METRE = 1.0, 1.0  # [s], [m]: of the pieces
_LONGEST = 1.5  # times that a piece may last, else there is a gap between its poses


@dataclasses.dataclass(frozen=True)
class RelativeError:
    """Root mean squares over all pieces."""

    translation: float  # [m]
    rotation: float     # [rad]


def relative_error(trajectory, truth, measure, length):
    """RelativeError over all pieces of a length, by a measure that grows along the poses; or None
    without any piece, and of truth without headings.

    measure: takes stamps (N) [ns] and true poses (N x 3), returns N values, such as `seconds`.
    """
    if not truth.has_heading:
        return None
    true, valid = interpolate(truth, trajectory.stamps)
    true, poses = true[valid], trajectory.poses[valid]
    if len(true) < 2:
        return None
    passed = measure(trajectory.stamps[valid], true)
    ends = np.searchsorted(passed, passed + length * (1.0 - 1e-6))
    starts = np.flatnonzero(ends < len(passed))
    starts = starts[passed[ends[starts]] - passed[starts] <= _LONGEST * length]
    if not len(starts):
        return None
    ends = ends[starts]
    error = se2.relative(se2.relative(true[starts], true[ends]),
                         se2.relative(poses[starts], poses[ends]))
    return RelativeError(float(np.sqrt(np.mean(np.sum(error[:, :2] ** 2, axis=1)))),
                         float(np.sqrt(np.mean(error[:, 2] ** 2))))


def seconds(stamps, _):
    """The time since the first pose [s]."""
    return (stamps - stamps[0]) / NANOSECONDS


def metres(_, true):
    """The length of the true way since the first pose [m]."""
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(true[:, :2], axis=0), axis=1)))


def relative_metrics(trajectory, truth):
    """The figures of pieces of a second and of a metre, by the keys of metrics.json."""
    found = {}
    for name, measure, length in (("1s", seconds, SECOND), ("1m", metres, METRE)):
        error = relative_error(trajectory, truth, measure, length)
        if error is not None:
            found[f"rpe_trans_{name}_m"] = error.translation
            found[f"rpe_rot_{name}_deg"] = float(np.degrees(error.rotation))
    return found
