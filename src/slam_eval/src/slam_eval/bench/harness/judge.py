# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Judges a run of a drive in which something goes wrong."""
import dataclasses
from typing import Optional

import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.honesty import intervals_of, LOST

SETTLE = 5.0  # after the fault began: from then on the pose is judged [s]
SECOND = 10**9


@dataclasses.dataclass(frozen=True)
class Outcome:
    """Of one run; times count from the beginning of the fault [s]."""

    ate: float                # root mean square error, not aligned [m]
    largest: float            # error [m]
    nees: Optional[float]     # median after SETTLE [1]
    wrong: Optional[float]    # share of the time after SETTLE, confidently wrong [1]
    told: Optional[float]     # when the run said that the robot is lost
    lost: float               # for how long it said so after the fault had begun
    false: int                # how often it said so before


def lost_since(intervals, begin):
    """(when the run first said that it is lost, for how long) [s], from `begin` [ns] on."""
    after = [(max(start, begin), end) for start, end in intervals if end > begin]
    told = (after[0][0] - begin) / SECOND if after else None
    return told, sum(end - start for start, end in after) / SECOND


def judge(run, begin, start=None):
    """The Outcome of a run. begin: of the fault, since the bag's start [s]; start: of the bag [ns],
    the first stamp of its truth by default."""
    result = evaluate(run)
    stamps = run.trajectory.stamps
    fault = int(run.truth.stamps[0] if start is None else start) + round(begin * SECOND)
    settled = stamps >= fault + round(SETTLE * SECOND)
    nees = None
    if result.consistency is not None:
        values = result.consistency.nees[settled[result.consistency.valid]]
        nees = float(np.median(values)) if len(values) else None
    if result.unaligned is None:
        raise BenchError("fewer than two poses of the run have truth")
    intervals = intervals_of(LOST, run.events or [], int(stamps[-1]))
    told, lost = lost_since(intervals, fault)
    return Outcome(result.unaligned.rmse, result.unaligned.max, nees,
                   result.claim and result.claim.share_wrong(settled), told, lost,
                   sum(since < fault for since, _ in intervals))
