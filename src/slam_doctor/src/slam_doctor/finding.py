# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a check says."""
import dataclasses
import enum
from typing import Optional


class Level(enum.Enum):
    """How bad it is, as it is printed."""

    OK = "OK"
    WARN = "WARN"
    ERROR = "ERROR"
    UNKNOWN = "cannot tell"


@dataclasses.dataclass(frozen=True)
class Finding:
    """The result of one check."""

    check: str   # name for scripts, such as "scan.rate"
    level: Level
    text: str    # what was found, with units
    advice: str = ""                # what to do, a sentence; of everything but OK
    value: Optional[float] = None   # the main figure
    unit: str = ""                  # of the value


def ok(check, text, value=None, unit=""):
    """A Finding that is as it should be."""
    return Finding(check, Level.OK, text, "", value, unit)


def warn(check, text, advice, value=None, unit=""):
    """A Finding with which SLAM works worse than it could."""
    return Finding(check, Level.WARN, text, advice, value, unit)


def error(check, text, advice, value=None, unit=""):
    """A Finding with which SLAM fails, or is wrong."""
    return Finding(check, Level.ERROR, text, advice, value, unit)


def unknown(check, text, advice):
    """A Finding of a check for which the data do not suffice."""
    return Finding(check, Level.UNKNOWN, text, advice)


def judged(check, text, advice, value, limits, unit=""):
    """OK, WARN or ERROR for a value >= 0 by the two limits (of WARN, of ERROR)."""
    if not value > limits[0]:
        return ok(check, text, value, unit)
    make = error if value > limits[1] else warn
    return make(check, text, advice, value, unit)
