# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a run was right to take its robot for lost, by the truth."""
import dataclasses
from typing import Optional

import numpy as np

from slam_eval.geometry import se2

LOST = 0.5     # the robot is, whose pose is further off than this [m]
AROUND = 3.0   # an alarm is right where the pose is off by that at most so long before or after [s]
NEAR = 5.0     # way within which it should come [m]


@dataclasses.dataclass(frozen=True)
class Verdict:
    """What became of a run. Times since its first step [s]; None where there is none."""

    hours: float
    wrong: Optional[float]    # from then on the robot was not where it took itself to be
    told: Optional[float]     # the first alarm
    way: Optional[float]      # from wrong to the alarm [m]; infinite without one
    is_false: bool            # the first alarm is one of a robot that was right

    @property
    def is_in_time(self):
        """Whether a robot that was wrong was told so within NEAR."""
        return self.wrong is not None and not self.is_false and self.way <= NEAR


def errors(run):
    """(times [s], distances from the truth [m], true way [m]) at each step.

    The map's origin is where the drive begins.
    """
    stamps = run.trajectory.stamps
    nearest = np.clip(np.searchsorted(run.truth.stamps, stamps), 0, len(run.truth) - 1)
    true = run.truth.poses[nearest]
    seen = se2.transform_poses(se2.inverse(true[0]), true)
    off = np.hypot(*(seen - run.trajectory.poses)[:, :2].T)
    steps = np.hypot(*np.diff(true[:, :2], axis=0).T)
    steps[steps > LOST] = 0.0  # carried
    return (stamps - stamps[0]) * 1e-9, off, np.concatenate([[0.0], np.cumsum(steps)])


def wrong_from_start(run):
    """The verdict on a run in a map of somewhere else."""
    times, _, way = errors(run)
    told = run.metrics.get("lost_first_s")
    distance = np.inf if told is None else np.interp(told, times, way)
    return Verdict(times[-1] / 3600.0, 0.0, told, distance, False)


def judge(run):
    """The verdict on a run with truth. A pose that is soon right again was found again."""
    times, off, way = errors(run)
    told = run.metrics.get("lost_first_s")
    wrong = None
    for i in np.flatnonzero(off > LOST):
        ahead = (way >= way[i]) & (way <= way[i] + NEAR) & (times >= times[i])
        if np.all(off[ahead] > LOST):
            wrong = i
            break
    is_false = told is not None and bool(np.all(off[np.abs(times - told) <= AROUND] <= LOST))
    if wrong is None:
        return Verdict(times[-1] / 3600.0, None, told, None, is_false)
    distance = np.inf
    if told is not None:
        distance = max(0.0, np.interp(told, times, way) - way[wrong])
    return Verdict(times[-1] / 3600.0, times[wrong], told, distance, is_false)
