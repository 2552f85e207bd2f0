# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a run took each observation for (associations.csv)."""
import collections

from slam_eval.io.errors import InputError, read_text

COLUMNS = ["stamp", "own_id", "taken_for", "landmark"]

Associated = collections.namedtuple("Associated", COLUMNS)


def read_associations(path):
    """Read associations.csv: a list of Associated, stamps in ns. Raises InputError."""
    lines = read_text(path).splitlines()
    if not lines or lines[0].split(",") != COLUMNS:
        raise InputError(f'{path}:1: the header is not "{",".join(COLUMNS)}"; '
                         "run the product again with this release")
    rows = []
    for number, line in enumerate(lines[1:], start=2):
        try:
            stamp, own_id, taken_for, landmark = line.split(",")
            seconds, _, fraction = stamp.partition(".")
            rows.append(Associated(int(seconds) * 10**9 + int(fraction), int(own_id), taken_for,
                                   int(landmark)))
        except ValueError:
            raise InputError(f"{path}:{number}: not {len(COLUMNS)} values; the file is cut off, "
                             "run the product again") from None
    return rows
