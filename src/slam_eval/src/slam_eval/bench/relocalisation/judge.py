# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a robot was found where it is, by where it was when the map was made."""
import dataclasses
import enum
from typing import Optional

import numpy as np

from slam_eval.geometry.se2 import wrap_angle
from slam_eval.io.trajectory import interpolate

CONFIDENT = (0.5, 0.2)  # standard deviations of position [m] and heading [rad] of who is sure
RIGHT = (0.5, 0.2)      # errors of who is right [m], [rad]
SIGMAS = 5.0            # beyond so many standard deviations an error contradicts the covariance

DEFINITIONS = (
    f"A robot is sure where it reports less than {CONFIDENT[0]} m and {CONFIDENT[1]} rad of standard "
    f"deviation. It is *right* where the first pose that it is sure of, and all such poses after "
    f"it, err by {RIGHT[0]} m and {RIGHT[1]} rad at most; *wrong* where a pose that it is sure of errs by "
    f"more than that and by more than {SIGMAS:g} standard deviations. Else it *did not know*.")


class Outcome(enum.Enum):
    """What became of a robot that did not know where it is."""

    RIGHT = "right"
    WRONG = "wrong"
    UNKNOWN = "did not know"


@dataclasses.dataclass(frozen=True)
class Verdict:
    """seconds: from the start until the robot was sure; error [m], turn [rad]: the largest since
    then. None where it never was."""

    outcome: Outcome
    seconds: Optional[float] = None
    error: Optional[float] = None
    turn: Optional[float] = None


def judge(run, truth, start, judged_from=0):
    """The verdict on a run, with times since a stamp [ns]; truth: a trajectory in the map's frame.
    Poses before the stamp judged_from [ns] do not count."""
    true, valid = interpolate(truth, run.trajectory.stamps)
    valid = valid & (run.trajectory.stamps >= judged_from)
    errors = run.trajectory.poses - true
    errors[:, 2] = wrap_angle(errors[:, 2])
    P = run.updates.covariances
    sure = (valid & (np.sqrt(P[:, 0, 0] + P[:, 1, 1]) < CONFIDENT[0])
            & (np.sqrt(P[:, 2, 2]) < CONFIDENT[1]))
    if not np.any(sure):
        return Verdict(Outcome.UNKNOWN)
    errors, P = errors[sure], P[sure]
    distances, turns = np.hypot(errors[:, 0], errors[:, 1]), np.abs(errors[:, 2])
    off = (distances > RIGHT[0]) | (turns > RIGHT[1])
    squared = np.einsum("ni,ni->n", errors, np.linalg.solve(P, errors[:, :, None])[:, :, 0])
    outcome = Outcome.UNKNOWN if np.any(off) else Outcome.RIGHT
    if np.any(off & (squared > SIGMAS ** 2)):
        outcome = Outcome.WRONG
    seconds = (run.trajectory.stamps[np.argmax(sure)] - start) * 1e-9
    return Verdict(outcome, float(seconds), float(distances.max()), float(turns.max()))
