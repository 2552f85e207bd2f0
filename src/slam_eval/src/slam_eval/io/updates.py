# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the filter said of itself at each step (updates.csv)."""
import dataclasses

import numpy as np

from slam_eval.io.csv_table import table_lines
from slam_eval.io.errors import InputError
from slam_eval.io.trajectory import parse_line

COLUMNS = ["stamp", "cov_xx", "cov_xy", "cov_xt", "cov_yy", "cov_yt", "cov_tt", "nis", "nis_dof",
           "used", "gated", "added", "unknown", "landmarks"]


@dataclasses.dataclass
class Updates:
    """Stamps [ns], pose covariances (N x 3 x 3), NIS and its degrees of freedom, counts by name."""

    stamps: np.ndarray
    covariances: np.ndarray
    nis: np.ndarray
    nis_dof: np.ndarray
    counts: dict

    def __len__(self):
        return len(self.stamps)


def read_updates(path):
    """Read updates.csv. Raises InputError that names file and line."""
    rows = [parse_line(where, line, ",", COLUMNS) for where, line in table_lines(path, COLUMNS)]
    if not rows:
        raise InputError(f"{path}: no update in the file; run the product again")
    values = np.array([row[1] for row in rows])
    xx, xy, xt, yy, yt, tt = values[:, :6].T
    covariances = np.array([[xx, xy, xt], [xy, yy, yt], [xt, yt, tt]]).transpose(2, 0, 1)
    counts = {name: values[:, COLUMNS.index(name) - 1].astype(int) for name in COLUMNS[9:]}
    return Updates(np.array([row[0] for row in rows], dtype=np.int64), covariances,
                   values[:, 6], values[:, 7].astype(int), counts)
