# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a sensor of landmarks says."""
import math

import numpy as np

FARTHEST = 200.0  # a landmark that is seen farther away is no landmark [m]


class ObservationRecord:
    """The observations of one topic."""

    def __init__(self):
        self.count = self.seen = self.invalid = self.bad_covariances = 0
        self.ids = set()

    def take(self, message):
        """Takes a message."""
        self.count += 1
        for seen in message.observations:
            self.seen += 1
            self.invalid += not (0 < seen.range < FARTHEST and abs(seen.bearing) <= 2 * math.pi)
            self.bad_covariances += is_bad(seen.covariance)
            if len(self.ids) < 10_000:
                self.ids.add(seen.id)


def is_bad(covariance):
    """Whether four numbers are no covariance, nor the -1 that stands for none."""
    if covariance[0] == -1:
        return False
    matrix = np.array(covariance).reshape(2, 2)
    return not np.isfinite(matrix).all() or matrix[0, 0] <= 0 or np.linalg.det(matrix) <= 0
