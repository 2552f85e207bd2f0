# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what a foreign system found as the files of a run."""
import json

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.trajectory import NANOSECONDS, Trajectory


def write_trajectory(path, trajectory):
    """A trajectory's file."""
    lines = []
    for stamp, (x, y, theta) in zip(trajectory.stamps, trajectory.poses):
        half = 0.5 * theta
        lines.append(f"{stamp // NANOSECONDS}.{stamp % NANOSECONDS:09d} {x:.9f} {y:.9f} "
                     f"0.000000000 0.000000000 0.000000000 {np.sin(half):.9f} {np.cos(half):.9f}\n")
    write_atomically(path, "".join(lines))


def write_landmarks(path, ids, positions):
    """A landmark map."""
    lines = "".join(f"  - {{id: {identity}, x: {x:.9f}, y: {y:.9f}}}\n"
                    for identity, (x, y) in zip(ids, positions))
    write_atomically(path, "version: 1\nframe: map\nunits: {position: m, angle: rad}\nlandmarks:"
                     + (f"\n{lines}" if lines else " []\n"))


def write_grid(folder, free, resolution, origin):
    """A grid as map_server reads it. free: probabilities [0..1] that cells are free, the row of the
    largest y first, 0.5 where nothing is known; resolution, origin [m]."""
    grey = np.round(255.0 * np.clip(free, 0.0, 1.0)).astype(np.uint8)
    header = f"P5\n{grey.shape[1]} {grey.shape[0]}\n255\n".encode("ascii")
    (folder / "map.pgm").write_bytes(header + grey.tobytes())
    write_atomically(folder / "map.yaml", (
        f"image: map.pgm\nresolution: {resolution:.9g}\norigin: [{origin[0]:.9g}, {origin[1]:.9g}, "
        "0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"))


def write_about(job, system, robot, usage, updates):
    """metrics.json and config.yaml: what it cost and which system it was on which robot."""
    metrics = {"updates": updates}
    if usage is not None:
        metrics.update(cpu_s=usage.cpu_s, wall_s=usage.wall_s, max_rss_mb=usage.max_rss_mb)
    write_atomically(job.folder / "metrics.json", json.dumps(metrics, indent=2) + "\n")
    settings = "".join(f"  {key}: {json.dumps(value)}\n" for key, value in
                       (setting.split("=", 1) for setting in job.settings))
    write_atomically(job.folder / "config.yaml",
                     f"version: 1\nproduct: {system}\nrobot: {json.dumps(robot)}\n"
                     f"seed: {job.seed}\n"
                     + (f"set:\n{settings}" if settings else ""))


def with_odometry_between(path, odometry):
    """A trajectory at all stamps of the odometry, from the path's first on: between the path's
    poses the odometry's motion since the last of them is added."""
    last = np.searchsorted(path.stamps, odometry.stamps, side="right") - 1
    covered = last >= 0
    at = np.searchsorted(odometry.stamps, path.stamps)
    poses = [se2.compose(path.poses[i], se2.compose(se2.inverse(odometry.poses[at[i]]), pose))
             for i, pose in zip(last[covered], odometry.poses[covered])]
    return Trajectory(odometry.stamps[covered], np.array(poses).reshape(-1, 3))
