# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which places a run recognised, against the truth: precision and recall.

A step recognises a place where the run says that it was there more than AWAY seconds before; it is
right where the truth of both stamps is within NEAR metres. A step could have recognised one where the
truth was within SAME metres and HEADING of a pose more than AWAY seconds before.
"""
import dataclasses

import numpy as np

from slam_eval.geometry.se2 import wrap_angle
from slam_eval.io.places import NOWHERE
from slam_eval.io.trajectory import interpolate

AWAY = 10.0                    # [s]
NEAR = 1.0                     # [m]
SAME = 0.5                     # [m]
HEADING = np.radians(30.0)
_SECOND = 1_000_000_000        # [ns]
_STEP = 0.1                    # [s]; earlier poses are looked through at this distance of time


@dataclasses.dataclass
class PlaceRecognition:
    """Of steps that have truth: how many recognised a place, how many of them rightly, how many
    could have, how many of these did rightly; the distances [m] of the recognised ones."""

    recognised: int
    right: int
    possible: int
    found: int
    distances: np.ndarray

    @property
    def metrics(self):
        """By the keys of metrics.json; None without a case."""
        return {"places_recognised": self.recognised,
                "place_precision": self.right / self.recognised if self.recognised else None,
                "place_recall": self.found / self.possible if self.possible else None,
                "place_error_max_m": (float(np.max(self.distances)) if self.recognised else None)}


def _could_recognise(stamps, poses):
    """Whether each pose has been about the same more than AWAY before. Stamps [ns] rise."""
    could = np.zeros(len(stamps), dtype=bool)
    if len(stamps) < 2:
        return could
    every = max(1, int(_STEP * _SECOND / max(1, np.median(np.diff(stamps)))))
    for i, (stamp, pose) in enumerate(zip(stamps, poses)):
        before = np.searchsorted(stamps, stamp - int(AWAY * _SECOND))
        earlier = poses[:before:every]
        near = np.linalg.norm(earlier[:, :2] - pose[:2], axis=1) <= SAME
        could[i] = np.any(near & (np.abs(wrap_angle(earlier[:, 2] - pose[2])) <= HEADING))
    return could


def place_recognition(visits, truth):
    """Compare visits with the truth; None where truth has no headings or no step has truth."""
    if not truth.has_heading or len(visits) == 0:
        return None
    poses, valid = interpolate(truth, visits.stamps)
    then, then_valid = interpolate(truth, np.where(visits.first == NOWHERE, visits.stamps,
                                                   visits.first))
    if not np.any(valid):
        return None
    away = visits.stamps - visits.first > int(AWAY * _SECOND)
    recognised = (visits.first != NOWHERE) & away & valid & then_valid
    distances = np.linalg.norm(poses[:, :2] - then[:, :2], axis=1)
    right = recognised & (distances <= NEAR)
    could = np.zeros(len(visits), dtype=bool)
    could[valid] = _could_recognise(visits.stamps[valid], poses[valid])
    return PlaceRecognition(int(np.sum(recognised)), int(np.sum(right)), int(np.sum(could)),
                            int(np.sum(could & right)), distances[recognised])
