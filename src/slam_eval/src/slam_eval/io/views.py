# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What became of the features of each image (views.csv)."""
import dataclasses

import numpy as np

from slam_eval.io.csv_table import table_lines
from slam_eval.io.errors import InputError
from slam_eval.io.trajectory import parse_line

COLUMNS = ["stamp", "features", "expected", "matched", "rejected"]
MOST = 10 ** 9  # of a count


@dataclasses.dataclass
class Views:
    """Stamps of the images [ns], and the counts of each by name."""

    stamps: np.ndarray
    counts: dict

    def __len__(self):
        return len(self.stamps)


def _view(where, line):
    stamp, counts = parse_line(where, line, ",", COLUMNS)
    if any(count < 0 or count > MOST or count != int(count) for count in counts):
        raise InputError(f"{where}: a count is no whole number from 0 to {MOST}; "
                         "run the product again")
    return stamp, counts


def read_views(path):
    """Read views.csv. Raises InputError that names file and line."""
    rows = [_view(where, line) for where, line in table_lines(path, COLUMNS)]
    counts = np.array([row[1] for row in rows], dtype=int).reshape(-1, len(COLUMNS) - 1)
    return Views(np.array([row[0] for row in rows], dtype=np.int64),
                 dict(zip(COLUMNS[1:], counts.T)))
