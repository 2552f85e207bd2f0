# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Landmark maps as a run writes them (landmarks.yaml, version 1)."""
import dataclasses
import re
from typing import Optional

import numpy as np
import yaml

from slam_eval.io.errors import InputError, read_text

_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclasses.dataclass
class LandmarkMap:
    """Ids of points, positions (N x 2) [m], covariances (N x 2 x 2) [m^2] and the last pose; and of
    lines the two ends of what was seen of them (N x 2 x 2) [m]. A run that associates by position
    has ids of its own, which are not those of the ground truth."""

    ids: list
    positions: np.ndarray
    covariances: np.ndarray
    pose: Optional[np.ndarray] = None
    lines: np.ndarray = dataclasses.field(default_factory=lambda: np.zeros((0, 2, 2)))
    has_own_ids: bool = False

    def __len__(self):
        return len(self.ids) + len(self.lines)


def match_by_id(estimate, truth):
    """Ids both maps hold, with their positions: (ids, estimate N x 2, truth N x 2). No
    ids where those of the estimate are its own."""
    position = {} if estimate.has_own_ids else dict(zip(truth.ids, truth.positions))
    rows = [i for i, landmark in enumerate(estimate.ids) if landmark in position]
    ids = [estimate.ids[i] for i in rows]
    true = np.array([position[landmark] for landmark in ids]).reshape(-1, 2)
    return ids, estimate.positions[rows].reshape(-1, 2), true


def _without_joint_covariance(text):
    """The text without its joint covariance: millions of numbers nobody needs here."""
    return re.sub(r"^joint_covariance:.*\n(?:(?:[ \t\-\]].*)?\n)*", "", text, flags=re.MULTILINE)


def _number(value):
    """A finite float, or None. YAML 1.1 takes 1e-05 for text, yet any C printf writes it so."""
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        return None
    try:
        number = float(value)
    except ValueError:
        return None
    return number if np.isfinite(number) else None


def _numbers(path, what, values, count):
    numbers = [_number(v) for v in (values if isinstance(values, list) else [values])]
    if len(numbers) != count or None in numbers:
        raise InputError(f"{path}: {what} is not {count} finite number{'s' * (count > 1)}; "
                         "save the map again")
    return numbers


def _load_document(path):
    try:
        document = yaml.load(_without_joint_covariance(read_text(path) + "\n"), Loader=_LOADER)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = f":{mark.line + 1}" if mark else ""
        raise InputError(f"{path}{line}: no valid YAML, the file is cut off or edited wrongly; "
                         "save the map again") from None
    if not isinstance(document, dict):
        raise InputError(f"{path}: no landmark map in the file; save the map again")
    if document.get("version") != 1:
        raise InputError(f"{path}: version is {document.get('version')}, this program reads "
                         "version 1; save the map again with this release")
    if not isinstance(document.get("landmarks"), (list, type(None))) or "landmarks" not in document:
        raise InputError(f'{path}: the list "landmarks" is missing; save the map again')
    return document


def _read_landmark(path, entry):
    identity = entry.get("id") if isinstance(entry, dict) else None
    if not isinstance(identity, int) or isinstance(identity, bool):
        raise InputError(f'{path}: a landmark has no whole number "id"; save the map again')
    what = f"landmark {identity}: "
    position = [_numbers(path, what + axis, entry.get(axis), 1)[0] for axis in ("x", "y")]
    covariance = entry.get("covariance", [0.0] * 4)
    return identity, position, _numbers(path, what + "covariance", covariance, 4)


def read_labels(path):
    """Read {id: label} of the file of labels that slam_labels writes. Raises InputError."""
    try:
        entries = yaml.safe_load(read_text(path))["landmarks"]
        return {int(entry["id"]): str(entry["label"]) for entry in entries if "id" in entry}
    except (yaml.YAMLError, TypeError, KeyError, ValueError):
        raise InputError(f"{path}: no labels as slam_labels saves them; save them again, or remove "
                         "the file") from None


def _is_line(entry):
    return isinstance(entry, dict) and entry.get("kind", "point") == "line"


def _read_line(path, entry):
    """The two ends of what was seen of a line."""
    identity, position, _ = _read_landmark(path, entry)
    direction, begin, end = (_numbers(path, f"landmark {identity}: {key}", entry.get(key), 1)[0]
                             for key in ("direction", "begin", "end"))
    along = np.array([-np.sin(direction), np.cos(direction)])
    return np.array(position) + np.outer([begin, end], along)


def read_landmarks(path):
    """Read a landmark map. Raises InputError that names file and field."""
    document = _load_document(path)
    entries = document["landmarks"] or []
    rows = [_read_landmark(path, entry) for entry in entries if not _is_line(entry)]
    lines = [_read_line(path, entry) for entry in entries if _is_line(entry)]
    ids = [row[0] for row in rows]
    for identity in ids:
        if len(set(ids)) != len(ids) and ids.count(identity) > 1:
            raise InputError(f"{path}: landmark {identity} stands there twice; save the map again")
    pose = document.get("pose")
    if pose is not None:
        if not isinstance(pose, dict):
            raise InputError(f'{path}: "pose" has no x, y, theta; save the map again')
        pose = np.array([_numbers(path, "pose: " + k, pose.get(k), 1)[0]
                         for k in ("x", "y", "theta")])
    return LandmarkMap(ids, np.array([row[1] for row in rows]).reshape(-1, 2),
                       np.array([row[2] for row in rows]).reshape(-1, 2, 2), pose,
                       np.array(lines).reshape(-1, 2, 2))
