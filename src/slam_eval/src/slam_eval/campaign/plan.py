# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign runs, as a file that the hosts read which run it."""
import dataclasses
import json
from typing import Optional

from slam_eval.io.errors import InputError


@dataclasses.dataclass(frozen=True)
class Drive:
    """A simulated drive, as slam_sim is called for it."""

    world: str  # a file
    robot: str  # a file
    seed: int
    duration: Optional[float] = None
    only: tuple = ()


@dataclasses.dataclass(frozen=True)
class Run:
    """A run, as the programs are called for it."""

    product: str          # a name or a file; of a foreign system its file
    is_foreign: bool
    settings: tuple
    seed: int
    bag: str              # a file, relative to the campaign's folder where that made it
    bag_sha256: str
    robot: Optional[str]  # a name or a file, where it is not the one that the bag names
    remap: tuple = ()
    world: Optional[str] = None      # the file of the simulated world
    relations: Optional[str] = None  # a file
    time_limit: float = 3600.0       # [s]


@dataclasses.dataclass(frozen=True)
class Row:
    """A line of the results: names of the file, and the run; or why there can be none. drive: the
    SHA-256 of the bag."""

    bag: str
    product: str
    seed: int
    run: Optional[str]
    failure: Optional[str] = None
    drive: Optional[str] = None


def read_result(path):
    """The content of a result's file. Raises InputError."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        raise InputError(f"{path}: cannot be read as a result; remove its folder and call the "
                         "campaign again") from None


class Plan:
    """Drives and runs by their names, and the rows of the results in the file's order."""

    def __init__(self, drives=None, runs=None, rows=()):
        self.drives, self.runs, self.rows = drives or {}, runs or {}, list(rows)

    def text(self):
        """As JSON."""
        return json.dumps({
            "drives": {name: dataclasses.asdict(drive) for name, drive in self.drives.items()},
            "runs": {name: dataclasses.asdict(run) for name, run in self.runs.items()}},
            indent=1) + "\n"


def read_drive(path, name):
    """A drive of a plan's file."""
    values = json.loads(path.read_text(encoding="utf-8"))["drives"][name]
    return Drive(**values)


def read_run(path, name):
    """A run of a plan's file."""
    values = json.loads(path.read_text(encoding="utf-8"))["runs"][name]
    return Run(**values)
