# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trajectories as a run writes them: lines `stamp tx ty tz qx qy qz qw`."""
import dataclasses
import decimal
from typing import Optional

import numpy as np

from slam_eval.geometry.se2 import wrap_angle
from slam_eval.io.errors import InputError, read_text

NANOSECONDS = 1_000_000_000
_COLUMNS = "stamp tx ty tz qx qy qz qw".split()


LONGEST_GAP = 0.5  # [s] inside which poses of a trajectory are interpolated
_POINT = "# point of the robot:"
_REMEDY = "run the product again, or mend the file if it is your own"


@dataclasses.dataclass
class Trajectory:
    """Stamps [ns] (int64, rising) and poses (N x 3: x [m], y [m], heading [rad]).

    Headings are NaN where truth has none; point: the point of the robot that they tell of [m];
    T_truth_map: of truth, where a map lies that the run has loaded, if that is known.
    """

    stamps: np.ndarray
    poses: np.ndarray
    point: tuple = (0.0, 0.0)
    T_truth_map: Optional[np.ndarray] = None

    @property
    def has_heading(self):
        return bool(np.all(np.isfinite(self.poses[:, 2])))

    def __len__(self):
        return len(self.stamps)


def parse_stamp(text):
    """Seconds as text to integer nanoseconds, exactly."""
    value = decimal.Decimal(text)
    if not value.is_finite():
        raise ValueError(text)
    return int((value * NANOSECONDS).to_integral_value())


def parse_line(where, line, separator, columns):
    """(stamp [ns], the other numbers) of a line of a file that a run wrote. Raises InputError."""
    fields = line.split(separator)
    if len(fields) != len(columns):
        raise InputError(f"{where}: {len(fields)} fields where {len(columns)} belong "
                         f"({(separator or ' ').join(columns)}): the line is cut off or of another "
                         f"format; {_REMEDY}")
    try:
        stamp, numbers = parse_stamp(fields[0]), [float(field) for field in fields[1:]]
    except (ValueError, decimal.InvalidOperation):
        raise InputError(f'{where}: "{line[:60]}" holds something that is no number; '
                         f"{_REMEDY}") from None
    if not np.all(np.isfinite(numbers)):
        raise InputError(f"{where}: a value is not finite (NaN or infinite); if a run wrote "
                         "it, that run failed: look at its messages")
    return stamp, numbers


def require_headings_alike(where, poses):
    """Refuses true poses (N x 3) of which some have a heading and others none. Raises
    InputError."""
    known = np.isfinite(poses[:, 2])
    if np.any(known) and not np.all(known):
        raise InputError(f"{where}: some poses have a heading and others none; give all of them "
                         "one, or none")


def _pose(where, numbers):
    x, y, _, qx, qy, qz, qw = numbers
    if (qx, qy, qz, qw) == (0.0, 0.0, 0.0, 0.0):
        return x, y, np.nan
    if abs(qx * qx + qy * qy + qz * qz + qw * qw - 1.0) > 1e-3:
        raise InputError(f"{where}: the quaternion has not length 1: the line is cut off or of "
                         f"another format; {_REMEDY}")
    return x, y, np.arctan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz))


def _point(where, line):
    try:
        x, y = (float(field) for field in line[len(_POINT):].split())
    except ValueError:
        raise InputError(f'{where}: "{line[:60]}" does not name a point by two numbers; '
                         f"{_REMEDY}") from None
    return x, y


def read_truth(path):
    """Read a true trajectory, whose lines may have no heading ("0 0 0 0" for the quaternion)."""
    stamps, poses, point = [], [], (0.0, 0.0)
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        where = f"{path}:{number}"
        if line.startswith(_POINT):
            point = _point(where, line)
        if not line.strip() or line.startswith("#"):
            continue
        stamp, numbers = parse_line(where, line, None, _COLUMNS)
        if stamps and stamp <= stamps[-1]:
            raise InputError(f"{where}: the stamp {line.split()[0]} is not after the one before; "
                             "stamps have to rise; sort the file or run the product again")
        stamps.append(stamp)
        poses.append(_pose(where, numbers))
    if not stamps:
        raise InputError(f"{path}: no pose in the file; {_REMEDY}")
    poses = np.array(poses, dtype=float)
    require_headings_alike(path, poses)
    return Trajectory(np.array(stamps, dtype=np.int64), poses, point)


def read_trajectory(path):
    """Read a trajectory file. Raises InputError that names file and line."""
    trajectory = read_truth(path)
    if not trajectory.has_heading:
        raise InputError(f"{path}: no pose has a heading; {_REMEDY}")
    return trajectory


def interpolate(truth, stamps, max_gap=LONGEST_GAP):
    """Truth at the given stamps [ns]: (poses N x 3, valid N).

    Position linearly, heading along the shorter way. Not valid: before the first and after the
    last truth pose, and inside a gap of truth longer than max_gap [s].
    """
    stamps = np.asarray(stamps, dtype=np.int64)
    after = np.clip(np.searchsorted(truth.stamps, stamps, side="left"), 0, len(truth) - 1)
    exact = truth.stamps[after] == stamps
    before = np.where(exact, after, np.maximum(after - 1, 0))
    t0, t1 = truth.stamps[before], truth.stamps[after]
    inside = (t0 <= stamps) & (stamps <= t1)
    valid = inside & (t1 - t0 <= int(max_gap * NANOSECONDS))
    share = np.where(t1 > t0, (stamps - t0) / np.maximum(t1 - t0, 1), 0.0)[:, None]
    start, end = truth.poses[before], truth.poses[after]
    delta = end - start
    delta[:, 2] = wrap_angle(delta[:, 2])
    poses = start + share * delta
    poses[:, 2] = wrap_angle(poses[:, 2])
    return poses, valid


def at_stamps(trajectory, stamps):
    """A trajectory with its poses interpolated to those of the stamps [ns] that it covers."""
    poses, valid = interpolate(trajectory, stamps)
    return Trajectory(np.asarray(stamps)[valid], poses[valid])
