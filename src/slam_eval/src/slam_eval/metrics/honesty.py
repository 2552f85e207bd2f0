# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the pose was wrong while its covariance said that it was right, and how long the run
itself reported the robot as lost."""
import dataclasses

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.trajectory import interpolate, NANOSECONDS

WRONG = 0.3      # an error of the position beyond this matters [m]
CONFIDENT = 5.0  # and contradicts the covariance beyond so many standard deviations
MISSED_AFTER = 5.0  # a pose that is confidently wrong for longer on end is a missed loss [s]


@dataclasses.dataclass(frozen=True)
class PositionClaim:
    """Of each pose: whether it has truth, its position's error [m], the Mahalanobis distance of
    that error by the reported covariance [1], and how long the pose stands until the next one [s].
    """

    valid: np.ndarray
    errors: np.ndarray
    distances: np.ndarray
    durations: np.ndarray

    @property
    def is_confidently_wrong(self):
        """Which of the poses are wrong beyond what they say."""
        return self.valid & (self.errors > WRONG) & (self.distances > CONFIDENT)

    @property
    def seconds_wrong(self):
        """Time for which the pose was confidently wrong [s]."""
        return float(np.sum(self.durations[self.is_confidently_wrong]))

    @property
    def missed_losses(self):
        """How often the pose was confidently wrong for more than MISSED_AFTER on end."""
        count, lasted = 0, 0.0
        for is_wrong, duration in zip(np.append(self.is_confidently_wrong, False),
                                      np.append(self.durations, 0.0)):
            if is_wrong:
                lasted += duration
                continue
            count += int(lasted > MISSED_AFTER)
            lasted = 0.0
        return count

    def share_wrong(self, chosen):
        """Share of the time of the chosen poses (a mask) that have truth for which the pose was
        confidently wrong; None where they last no time."""
        time = np.sum(self.durations[chosen & self.valid])
        if time <= 0.0:
            return None
        return float(np.sum(self.durations[chosen & self.is_confidently_wrong]) / time)


def frame_of_map(trajectory, truth):
    """T_truth_map, without a fit: that of the loaded map where it is known, else by the first pose
    that has truth; None where fewer than two poses have truth, or truth has no headings."""
    if not truth.has_heading:
        return None
    true, valid = interpolate(truth, trajectory.stamps)
    if np.count_nonzero(valid) < 2:
        return None
    if truth.T_truth_map is not None:
        return truth.T_truth_map
    first = int(np.argmax(valid))
    return se2.compose(true[first], se2.inverse(trajectory.poses[first]))


def truth_in_map(trajectory, truth):
    """(poses N x 3, valid N) of truth at the trajectory's stamps, in the frame_of_map(); None where
    there is none."""
    T_truth_map = frame_of_map(trajectory, truth)
    if T_truth_map is None:
        return None
    true, valid = interpolate(truth, trajectory.stamps)
    return se2.transform_poses(se2.inverse(T_truth_map), true), valid


def _mahalanobis(errors, covariances):
    """Of each error; infinite where a covariance is singular and the error lies outside of it."""
    values, axes = np.linalg.eigh(covariances)
    along = np.einsum("nij,ni->nj", axes, errors)
    with np.errstate(divide="ignore", invalid="ignore"):
        terms = np.where(along == 0.0, 0.0, along ** 2 / np.maximum(values, 0.0))
    return np.sqrt(np.sum(terms, axis=1))


def durations(stamps):
    """How long each pose stands until the next one [s]; 0 for the last one."""
    return np.append(np.diff(stamps), 0) / NANOSECONDS


def position_claim(trajectory, updates, truth):
    """The PositionClaim of a run, or None where truth_in_map() has none, and where the run claims
    nothing: all its covariances are zero, which says that they are unknown."""
    moved = truth_in_map(trajectory, truth)
    if moved is None or not np.any(updates.covariances):
        return None
    true, valid = moved
    errors = trajectory.poses[:, :2] - true[:, :2]
    return PositionClaim(valid, np.linalg.norm(errors, axis=1),
                         _mahalanobis(errors, updates.covariances[:, :2, :2]),
                         durations(trajectory.stamps))


# of the events: what begins a time and what ends it
LOST = ("lost", ("found",))
DOUBTFUL = ("doubtful", ("confident", "lost"))


def intervals_of(state, events, end):
    """(from, to) [ns] of each time for which the events report the robot in a state; the last one
    lasts until `end` [ns] where nothing ended it."""
    begins, ends = state
    intervals, since = [], None
    for event in events:
        if event.kind == begins and since is None:
            since = event.stamp
        elif event.kind in ends and since is not None:
            intervals.append((since, event.stamp))
            since = None
    if since is not None:
        intervals.append((since, max(since, end)))
    return intervals


def seconds_in(state, run):
    """Time for which a run reported its robot in a state [s]; None where it has no events, or where
    its product cannot tell."""
    if run.events is None:
        return None
    intervals = intervals_of(state, run.events, int(run.trajectory.stamps[-1]))
    if not intervals and "lost_alarms" not in run.metrics:
        return None
    return sum(end - start for start, end in intervals) / NANOSECONDS


def false_losses(claim, run):
    """How often the run reported its robot as lost while the position was right, by the last pose
    until then; None where it cannot be known, or the product cannot tell."""
    if claim is None or seconds_in(LOST, run) is None:
        return None
    count = 0
    for begin, _ in intervals_of(LOST, run.events, int(run.trajectory.stamps[-1])):
        last = int(np.searchsorted(run.trajectory.stamps, begin, side="right")) - 1
        count += int(last >= 0 and claim.valid[last] and claim.errors[last] <= WRONG)
    return count
