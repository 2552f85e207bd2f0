# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the filter said of itself at each step (updates.csv)."""
import dataclasses

import numpy as np

from slam_eval.errors import InputError, read_text
from slam_eval.trajectory import parse_stamp

COLUMNS = ['stamp', 'cov_xx', 'cov_xy', 'cov_xt', 'cov_yy', 'cov_yt', 'cov_tt', 'nis', 'nis_dof',
           'used', 'gated', 'added', 'unknown', 'landmarks']


@dataclasses.dataclass
class Updates:
    """Stamps [ns], pose covariances (N x 3 x 3), NIS and its degrees of freedom, counts by name."""

    stamps: np.ndarray
    covariances: np.ndarray
    nis: np.ndarray
    nis_dof: np.ndarray
    counts: dict

    def __len__(self):
        return len(self.stamps)


def _parse_line(where, line):
    fields = line.split(',')
    if len(fields) != len(COLUMNS):
        raise InputError(f'{where}: {len(fields)} columns where {len(COLUMNS)} belong: the line is '
                         'cut off or of another format; run the product again')
    try:
        stamp, numbers = parse_stamp(fields[0]), [float(field) for field in fields[1:]]
    except (ValueError, ArithmeticError):
        raise InputError(f'{where}: "{line[:60]}" holds something that is no number; '
                         'run the product again') from None
    if not np.all(np.isfinite(numbers)):
        raise InputError(f'{where}: a value is not finite (NaN or infinite); the run that wrote '
                         'it failed, look at its messages')
    return stamp, numbers


def read_updates(path):
    """Read updates.csv. Raises InputError that names file and line."""
    lines = read_text(path).splitlines()
    if lines[0].strip().split(',') != COLUMNS:
        raise InputError(f'{path}:1: the header is not "{",".join(COLUMNS)}"; '
                         'run the product again with this release')
    rows = [_parse_line(f'{path}:{number}', line)
            for number, line in enumerate(lines[1:], start=2) if line.strip()]
    if not rows:
        raise InputError(f'{path}: no update in the file; run the product again')
    values = np.array([row[1] for row in rows])
    xx, xy, xt, yy, yt, tt = values[:, :6].T
    covariances = np.array([[xx, xy, xt], [xy, yy, yt], [xt, yt, tt]]).transpose(2, 0, 1)
    counts = {name: values[:, COLUMNS.index(name) - 1].astype(int) for name in COLUMNS[9:]}
    return Updates(np.array([row[0] for row in rows], dtype=np.int64), covariances,
                   values[:, 6], values[:, 7].astype(int), counts)
