# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Landmarks in files of MRPT (2.x): truth tables, kf-slam's scenes, ids in rawlogs.

kf-slam writes its map in no text file (the y of its 2-D MATLAB script is 0), but its scene
`kf_state_NNNNN.3Dscene` holds one 2-D ellipse per landmark, named by the landmark's index in the
filter's state. A landmark enters the state when the rawlog shows its id for the first time, in
the order of the readings of the observation.
"""
import gzip
import re
import struct

import numpy as np

from slam_eval.io.errors import InputError, read_text
from slam_eval.io.landmarks import LandmarkMap, read_landmarks

_ELLIPSE = re.compile(rb"mrpt::opengl::CEllipsoid2D\x00")
_OBSERVATION = re.compile(rb"CObservationBearingRange\x03")
_POSE_3D = re.compile(rb"(?:mrpt::poses::)?CPose3D([\x02\x03])")
_POSE_3D_BYTES = {2: 7 * 8, 3: 12 * 8}  # quaternion; rotation matrix


def read_truth_table(path):
    """Ground truth of simul-landmarks: a line `x y z . . . id` per landmark."""
    rows = {}
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        fields = line.split("%")[0].split()
        if not fields:
            continue
        try:
            x, y, identity = float(fields[0]), float(fields[1]), int(fields[6])
            if not (np.isfinite(x) and np.isfinite(y)):
                raise ValueError
        except (ValueError, IndexError):
            raise InputError(f'{path}:{number}: not the 7 numbers "x y z . . . id" of an MRPT '
                             "landmark table; check the path") from None
        rows[identity] = (x, y)
    return LandmarkMap(list(rows), np.array(list(rows.values())).reshape(-1, 2),
                       np.zeros((len(rows), 2, 2)))


def _read_binary(path):
    try:
        data = path.read_bytes()
        return gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    except FileNotFoundError:
        raise InputError(f"{path}: no such file; check the path") from None
    except (OSError, EOFError) as error:
        raise InputError(f"{path}: cannot be read ({error}); write it again") from None


def _read_ellipse(data, start):
    """Name and position of an ellipse whose class name ends at start.

    Layout: 2 bytes signature, name length (2 bytes), name, colour (4 bytes), x, y, z (float).
    """
    length = struct.unpack_from("<H", data, start + 2)[0]
    name = data[start + 4:start + 4 + length].decode("ascii")
    x, y, _ = struct.unpack_from("<3f", data, start + 8 + length)
    return name, x, y


def read_scene(path):
    """Landmark positions of a kf-slam scene in the order of the filter's state (N x 2)."""
    data = _read_binary(path)
    positions = {}
    try:
        for match in _ELLIPSE.finditer(data):
            name, x, y = _read_ellipse(data, match.end())
            if name:  # the ellipse without a name is the robot
                positions[int(name)] = (x, y)
    except (struct.error, ValueError):
        raise InputError(f"{path}: cut off or of another release of MRPT; "
                         "run kf-slam again") from None
    if sorted(positions) != list(range(len(positions))) or not positions:
        raise InputError(f"{path}: no landmarks of a 2-D kf-slam in this scene; run kf-slam with "
                         "kf_implementation = CRangeBearingKFSLAM2D")
    return np.array([positions[i] for i in range(len(positions))], dtype=float)


def _read_ids(data, start):
    """Landmark ids of an observation (class version 3) whose version byte ends at start."""
    pose = _POSE_3D.match(data, start + 16 + 1)
    end = pose.end() + _POSE_3D_BYTES[pose.group(1)[0]] + 1  # 1: end mark of the pose
    own_covariances, = struct.unpack_from("<?", data, end + 8)
    if own_covariances:
        raise ValueError("readings with covariances")
    count, = struct.unpack_from("<I", data, end + 8 + 1 + 12)
    first = end + 8 + 1 + 12 + 4
    return [struct.unpack_from("<3fi", data, first + 16 * i)[3] for i in range(count)]


def read_id_order(path):
    """Landmark ids of a rawlog in the order in which they are seen for the first time."""
    data = _read_binary(path)
    order = {}
    try:
        for match in _OBSERVATION.finditer(data):
            order.update(dict.fromkeys(_read_ids(data, match.end())))
    except (struct.error, ValueError, AttributeError):
        raise InputError(f"{path}: its range-bearing readings are cut off or of a kind that is "
                         "not read here (with covariances of their own)") from None
    if not order or any(identity < 0 for identity in order):
        raise InputError(f"{path}: no range-bearing readings with known ids in this rawlog")
    return list(order)


def read_kf_slam_map(scene, rawlog):
    """The map of a kf-slam scene with the ids of the rawlog it was run on."""
    positions, order = read_scene(scene), read_id_order(rawlog)
    if len(order) < len(positions):
        raise InputError(f"{scene}: {len(positions)} landmarks, but {rawlog} shows only "
                         f"{len(order)} ids; give the rawlog kf-slam was run on")
    return LandmarkMap(order[:len(positions)], positions, np.zeros((len(positions), 2, 2)))


def read_map(path, rawlog=None):
    """A map by the ending of its name: .yaml (ours), .3Dscene (kf-slam), else MRPT's table."""
    if path.suffix in (".yaml", ".yml"):
        return read_landmarks(path)
    if path.suffix == ".3Dscene":
        if rawlog is None:
            raise InputError(f"{path}: holds no landmark ids; give the rawlog kf-slam was run on "
                             "with --rawlog")
        return read_kf_slam_map(path, rawlog)
    return read_truth_table(path)
