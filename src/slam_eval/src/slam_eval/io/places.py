# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The places that a run took itself to be at (places.csv)."""
import dataclasses
import decimal

import numpy as np

from slam_eval.io.csv_table import table_lines
from slam_eval.io.errors import InputError
from slam_eval.io.trajectory import parse_stamp

COLUMNS = ["stamp", "first_visit"]
NOWHERE = -1


@dataclasses.dataclass
class PlaceVisits:
    """Stamps of the steps [ns], and when the place of each was visited first [ns]: NOWHERE where
    the run recognised nothing."""

    stamps: np.ndarray
    first: np.ndarray

    def __len__(self):
        return len(self.stamps)


def _visit(where, line):
    fields = line.split(",")
    if len(fields) != len(COLUMNS):
        raise InputError(f"{where}: {len(fields)} fields where {len(COLUMNS)} belong "
                         f"({' '.join(COLUMNS)}): the line is cut off or of another format; "
                         "run the product again")
    try:
        stamp = parse_stamp(fields[0])
        first = parse_stamp(fields[1]) if fields[1] else NOWHERE
    except (ValueError, decimal.InvalidOperation):
        raise InputError(f"{where}: a stamp is no number; run the product again") from None
    if first > stamp:
        raise InputError(f"{where}: the place was visited first after this visit; "
                         "run the product again")
    return stamp, first


def read_places(path):
    """Read places.csv. Raises InputError that names file and line."""
    visits = [_visit(where, line) for where, line in table_lines(path, COLUMNS)]
    table = np.array(visits, dtype=np.int64).reshape(-1, 2)
    return PlaceVisits(table[:, 0], table[:, 1])
