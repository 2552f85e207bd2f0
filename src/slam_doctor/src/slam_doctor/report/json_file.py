# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Findings for scripts."""
import json
import math
import pathlib

from slam_doctor.errors import InputError
from slam_doctor.finding import Level


def as_data(name, duration, groups):
    """What the file holds. level: ok, warn, error or unknown; value: null where there is none."""
    return {"version": 1, "source": name, "duration_s": duration,
            "worst": worst(groups),
            "findings": [{"group": title, "check": each.check, "level": each.level.name.lower(),
                          "text": each.text, "advice": each.advice, "value": number(each.value),
                          "unit": each.unit}
                         for title, findings in groups.items() for each in findings]}


def number(value):
    """A value as JSON may have it."""
    return float(value) if value is not None and math.isfinite(value) else None


def worst(groups):
    """The worst level of all; what cannot be told is no fault."""
    levels = {each.level for findings in groups.values() for each in findings}
    return next((level.name.lower() for level in (Level.ERROR, Level.WARN) if level in levels),
                "ok")


def write(path, data):
    """Writes the file. Raises InputError."""
    try:
        pathlib.Path(path).write_text(json.dumps(data, indent=2) + "\n", encoding="utf-8")
    except OSError as fault:
        raise InputError(f"cannot write {path}: {fault.strerror}") from None
