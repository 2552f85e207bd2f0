# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What happened in a run that others should know of (events.csv)."""
import csv
import dataclasses
import decimal
import math

from slam_eval.io.errors import InputError, read_text
from slam_eval.io.trajectory import parse_stamp

COLUMNS = ["stamp", "kind", "distance", "turn", "reason"]


@dataclasses.dataclass
class Event:
    """Stamp [ns], kind, by how much the pose moved [m] and turned [rad], and why."""

    stamp: int
    kind: str
    distance: float
    turn: float
    reason: str


def _event(where, row):
    if len(row) != len(COLUMNS):
        raise InputError(f"{where}: {len(row)} fields where {len(COLUMNS)} belong "
                         f"({' '.join(COLUMNS)}): the line is cut off or of another format; "
                         "run the product again")
    try:
        event = Event(parse_stamp(row[0]), row[1], float(row[2]), float(row[3]), row[4])
    except (ValueError, decimal.InvalidOperation):
        raise InputError(f"{where}: stamp, distance or turn is no number; "
                         "run the product again") from None
    if not math.isfinite(event.distance) or not math.isfinite(event.turn):
        raise InputError(f"{where}: a value is not finite (NaN or infinite); the run that wrote "
                         "it failed, look at its messages")
    return event


def read_events(path):
    """Read events.csv, which may hold none. Raises InputError that names file and line."""
    rows = list(csv.reader(read_text(path).splitlines()))
    if not rows or rows[0] != COLUMNS:
        raise InputError(f'{path}:1: the header is not "{",".join(COLUMNS)}"; '
                         "run the product again with this release")
    return [_event(f"{path}:{number}", row) for number, row in enumerate(rows[1:], start=2) if row]
