# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bag as a rawlog for MRPT's programs, and the path that rbpf-slam found in it."""
import dataclasses
import pathlib

import numpy as np

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.io.trajectory import Trajectory

# Between frames: an update of rbpf-slam costs some 20 ms with 25 particles.
DISTANCE, ANGLE = 0.3, 0.3  # [m], [rad]


@dataclasses.dataclass(frozen=True)
class BagRawlog:
    """The rawlog, the odometry at each scan of the bag, and which scans are frames of the
    rawlog."""

    path: pathlib.Path
    odometry: Trajectory
    is_frame: np.ndarray


def parse_scans(text):
    """(odometry, is_frame) of what slam_eval_rawlog prints."""
    rows = [line.split() for line in text.splitlines()]
    stamps = np.array([int(row[0]) for row in rows], dtype=np.int64)
    poses = np.array([[float(value) for value in row[1:4]] for row in rows])
    return Trajectory(stamps, poses), np.array([row[4] == "1" for row in rows])


def make_rawlog(context, name, bag):
    """The BagRawlog of a bag. Raises BenchError where it holds no scans with odometry."""
    rawlog, log = context.work / f"{name}.rawlog", context.work / f"{name}_rawlog.txt"
    call(context, f"{name}: rawlog",
         [workspace_program("slam_eval", "slam_eval_rawlog"), bag, rawlog,
          "--distance", DISTANCE, "--angle", ANGLE], log)
    return BagRawlog(rawlog, *parse_scans(log.read_text(encoding="utf-8")))


def read_path(folder, rawlog):
    """The path of the most likely particle at the end: a pose for each frame after the first
    line, which is the start."""
    path = folder / "most_likely_path.txt"
    stamps = rawlog.odometry.stamps[rawlog.is_frame]
    try:
        poses = np.loadtxt(path, ndmin=2)[1:]
    except (OSError, ValueError):
        poses = np.empty((0, 3))
    if poses.shape != (len(stamps), 3):
        raise BenchError(f"{path} does not hold a pose for each of {len(stamps)} frames: rbpf-slam "
                         "is of another version")
    return Trajectory(stamps, poses)
