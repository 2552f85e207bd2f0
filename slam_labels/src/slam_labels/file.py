# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The file of labels: labels.yaml, version 1.

    version: 1
    landmarks:
      - {id: 3, label: door of the kitchen}
      - {x: 1.2, y: -0.5, label: fire extinguisher}   # in the map frame [m]
"""
import math
import os
import pathlib

import yaml

from slam_labels.labels import Label, LabelError

NAME = "labels.yaml"
KEYS = ("id", "x", "y", "label")


def path_of(file_or_folder):
    """The file that a path means: what does not end with .yaml is a folder with a labels.yaml."""
    path = pathlib.Path(file_or_folder)
    return path if path.suffix == ".yaml" else path / NAME


def read(path):
    """The Labels of a file, in its order. Raises LabelError, one sentence that names the file."""
    try:
        if not path.is_file():
            raise LabelError(f"{path}: there is no such file of labels")
        document = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError, yaml.YAMLError) as error:  # no such date, too deep
        reason = " ".join(str(error).split())
        raise LabelError(f"{path}: the labels cannot be read: {reason}") from error
    if not isinstance(document, dict) or set(document) != {"version", "landmarks"}:
        raise LabelError(f"{path}: a file of labels has the keys version and landmarks, and no other")
    if document["version"] != 1:
        raise LabelError(f"{path}: version is {document['version']}; this program reads version 1")
    entries = document["landmarks"]
    if not isinstance(entries, list):
        raise LabelError(f"{path}: landmarks is no list")
    labels = [read_entry(f"{path}: entry {number}", entry)
              for number, entry in enumerate(entries, 1)]
    require_one_each(path, labels)
    return labels


def read_entry(where, entry):
    if not isinstance(entry, dict) or not set(entry) <= set(KEYS):
        other = sorted(map(str, set(entry) - set(KEYS))) if isinstance(entry, dict) else []
        raise LabelError(f"{where} has the keys {', '.join(KEYS)} and no other"
                         f"{': not ' + ', '.join(other) if other else ''}")
    text = entry.get("label")
    if not isinstance(text, str) or not text.strip():
        raise LabelError(f"{where} has no label, a text that is not empty (in quotes where it is a "
                         "number)")
    if "id" not in entry and not {"x", "y"} <= set(entry):
        raise LabelError(f"{where} ('{text}') names no landmark: it needs an id, or x and y")
    identity = entry.get("id")
    if "id" in entry and (type(identity) is not int or abs(identity) >= 2**63):
        raise LabelError(f"{where} ('{text}'): the id {identity} is no whole number of 64 bits")
    return Label(text.strip(), identity, place_of(where, entry))


def place_of(where, entry):
    if not {"x", "y"} & set(entry):
        return None
    place = tuple(entry.get(axis) for axis in ("x", "y"))
    for value in place:
        if not is_finite(value):
            raise LabelError(f"{where}: x and y are not two finite numbers [m]")
    return tuple(map(float, place))


def is_finite(value):
    """Whether a value of a file or a parameter is a number that a float can be."""
    try:
        return type(value) in (int, float) and math.isfinite(value)
    except OverflowError:  # an int of hundreds of digits
        return False


def require_one_each(path, labels):
    """Refuses two labels of one landmark."""
    by_id = {}
    for label in labels:
        other = by_id.setdefault(label.id, label) if label.id is not None else label
        if other is not label:
            raise LabelError(f"{path}: landmark {label.id} has two labels, '{other.text}' and "
                             f"'{label.text}'; leave one of them out")


def write(path, labels):
    """Writes Labels, atomically. Raises LabelError."""
    entries = []
    for label in labels:
        entry = {} if label.id is None else {"id": label.id}
        if label.place is not None:
            entry.update(x=label.place[0], y=label.place[1])
        entries.append({**entry, "label": label.text})
    text = yaml.safe_dump({"version": 1, "landmarks": entries}, sort_keys=False, allow_unicode=True)
    beside = path.with_name(path.name + ".part")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        beside.write_text(text, encoding="utf-8")
        os.replace(beside, path)
    except OSError as error:
        raise LabelError(f"cannot write the labels to {path}: {error.strerror}") from error
