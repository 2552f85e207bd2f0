# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference relations between poses of a log (Kuemmerle et al. 2009), and the stamps of its scans.

A relation says where the robot of one stamp stands in the frame of another.
"""
import collections
import dataclasses
import decimal

import numpy as np

from slam_eval.io.errors import InputError, read_text
from slam_eval.io.trajectory import parse_stamp

_RELATION_COLUMNS = "stamp stamp x y z roll pitch yaw"
_STAMPS_HEADER = "source_stamp,written_stamp"


@dataclasses.dataclass
class Relations:
    """Stamps [ns] of the two poses, and the second in the frame of the first (N x 3)."""

    stamps: np.ndarray
    deltas: np.ndarray

    def __len__(self):
        return len(self.stamps)


@dataclasses.dataclass
class SourceStamps:
    """Stamps [ns] a log had and those its bag has; of several scans of one stamp the last."""

    source: np.ndarray
    written: np.ndarray
    scans: np.ndarray = None  # scans of each source stamp; none given: one each

    def __post_init__(self):
        if self.scans is None:
            self.scans = np.ones(len(self.source), dtype=np.int64)


def _rows(path, separator, columns):
    """(place, fields) of each line that is neither empty nor a comment."""
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        fields = line.split(separator)
        if len(fields) != columns.count(separator or " ") + 1:
            raise InputError(f'{path}:{number}: {len(fields)} fields where "{columns}" belong: the '
                             "line is cut off or of another format")
        yield f"{path}:{number}", fields


def _parse(place, stamps, numbers):
    try:
        parsed = [parse_stamp(text) for text in stamps], [float(text) for text in numbers]
    except (ValueError, decimal.InvalidOperation):
        raise InputError(f"{place}: holds something that is no number") from None
    if not np.all(np.isfinite(parsed[1])):
        raise InputError(f"{place}: a value is not finite")
    return parsed


def read_relations(path):
    """Read a file of relations. Raises InputError that names file and line."""
    stamps, deltas = [], []
    for place, fields in _rows(path, None, _RELATION_COLUMNS):
        pair, (x, y, _, _, _, yaw) = _parse(place, fields[:2], fields[2:])
        stamps.append(pair)
        deltas.append((x, y, yaw))
    if not stamps:
        raise InputError(f"{path}: holds no relation")
    return Relations(np.array(stamps, dtype=np.int64), np.array(deltas))


def read_source_stamps(path):
    """Read the table that an importer writes beside its bag. Raises InputError."""
    last, scans = {}, collections.Counter()
    for place, fields in _rows(path, ",", _STAMPS_HEADER):
        if ",".join(fields) != _STAMPS_HEADER:
            (source, written), _ = _parse(place, fields, [])
            last[source] = written
            scans[source] += 1
    if not last:
        raise InputError(f"{path}: holds no stamps; import the log anew")
    source, written = np.array(sorted(last.items()), dtype=np.int64).T
    return SourceStamps(source, written, np.array([scans[stamp] for stamp in source.tolist()]))
