# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The logs of benchmark laser: found, imported, and their relations."""
import collections
import dataclasses
import pathlib
from typing import Optional

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import data_folder
from slam_eval.bench.harness.runs import import_log
from slam_eval.io.relations import read_relations, read_source_stamps, Relations, SourceStamps
from slam_eval.io.trajectory import NANOSECONDS
from slam_eval.metrics.relations import relation_errors

FORMATS = {".clf": "carmen", ".log": "carmen", ".rawlog": "rawlog", ".bag": None}


@dataclasses.dataclass(frozen=True)
class Log:
    """A log as a bag; its relations and the stamps that it had, where there are any."""

    name: str
    bag: pathlib.Path
    is_imported: bool
    relations: Optional[Relations]
    stamps: Optional[SourceStamps]

    def judge(self, trajectory, odometry, tolerance):
        """RelationErrors of a trajectory, or None. tolerance [s]."""
        if self.relations is None:
            return None
        return relation_errors(self.relations, trajectory, odometry, self.stamps,
                               round(tolerance * NANOSECONDS))


def default_logs():
    """The CARMEN logs among the shared data."""
    return sorted(data_folder("laser").glob("*.clf"))


def names_of(paths):
    """A name for each path: the file's, with a number where several are called the same."""
    seen, names = collections.Counter(), []
    for path in paths:
        seen[path.stem] += 1
        names.append(path.stem + (f"_{seen[path.stem]}" if seen[path.stem] > 1 else ""))
    return names


def _optional(path, reader):
    return reader(path) if path.is_file() else None


def open_log(context, name, path):
    """The Log of a file, imported where it is no bag. Raises BenchError, InputError."""
    if path.suffix not in FORMATS:
        raise BenchError(f"{path} is no log that is known here: its name has to end with one of "
                         f"{', '.join(FORMATS)}")
    form = FORMATS[path.suffix]
    relations = _optional(path.with_suffix(".relations"), read_relations)
    bag = path if form is None else import_log(context, name, [form, path])
    stamps = _optional(bag.with_name(bag.name + ".stamps.csv"), read_source_stamps)
    return Log(name, bag, form is not None, relations, stamps)
