# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many landmarks of a map are there, and how many that are there are in the map."""
import dataclasses

import numpy as np
from scipy.optimize import linear_sum_assignment

from slam_eval.geometry import se2

RADIUS = 0.5  # [m] within which an estimated landmark may be a true one
_NO_PAIR = 1e6  # more than all distances of pairs together


@dataclasses.dataclass(frozen=True)
class LandmarkDetection:
    """Landmarks in the map, true ones, and pairs of both that lie within RADIUS of one another."""

    estimated: int
    true: int
    pairs: int

    @property
    def metrics(self):
        """The keys of metrics.json."""
        values = {}
        if self.estimated:
            values["landmark_precision_percent"] = 100.0 * self.pairs / self.estimated
        if self.true:
            values["landmark_recall_percent"] = 100.0 * self.pairs / self.true
        return values


def count_pairs(estimate, truth, radius):
    """How many pairs of points (N x 2, M x 2) can be made that lie at most radius [m] apart, each
    point in one pair at most: as many as possible."""
    if not len(estimate) or not len(truth):
        return 0
    distances = np.linalg.norm(estimate[:, None] - truth[None], axis=2)
    rows, columns = linear_sum_assignment(np.where(distances <= radius, distances, _NO_PAIR))
    return int(np.count_nonzero(distances[rows, columns] <= radius))


def landmark_detection(estimate, truth, T_truth_map):
    """LandmarkDetection of two LandmarkMaps, whatever their ids; None for maps of lines."""
    if len(estimate.lines) or len(truth.lines):
        return None
    moved = se2.transform_points(T_truth_map, estimate.positions.reshape(-1, 2))
    return LandmarkDetection(len(estimate.ids), len(truth.ids),
                             count_pairs(moved, truth.positions.reshape(-1, 2), RADIUS))
