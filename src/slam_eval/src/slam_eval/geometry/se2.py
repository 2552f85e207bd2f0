# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planar rigid motions. A pose is (x [m], y [m], heading [rad]); N poses are an N x 3 array."""
import numpy as np


def wrap_angle(angle):
    """Angle [rad] wrapped to (-pi, pi]."""
    return np.pi - np.mod(np.pi - np.asarray(angle, dtype=float), 2.0 * np.pi)


def rotation(angle):
    """2 x 2 rotation matrix of an angle [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


def transform_points(T, points):
    """The points (N x 2) moved by the pose T."""
    return np.asarray(points, dtype=float) @ rotation(T[2]).T + np.asarray(T[:2], dtype=float)


def transform_poses(T, poses):
    """T composed with each of the poses (N x 3), from the left."""
    poses = np.asarray(poses, dtype=float)
    heading = wrap_angle(poses[:, 2] + T[2])
    return np.column_stack([transform_points(T, poses[:, :2]), heading])


def compose(a, b):
    """The pose a * b."""
    return transform_poses(a, np.asarray(b, dtype=float)[None, :])[0]


def inverse(T):
    """The pose that undoes T."""
    x, y = -rotation(T[2]).T @ np.asarray(T[:2], dtype=float)
    return np.array([x, y, wrap_angle(-T[2])])


def relative(starts, ends):
    """Each end (N x 3) in the frame of its start (N x 3)."""
    # NumPy's sine of a column has other last bits than that of a plain array, or the same, by
    # where the memory of its result happens to lie.
    heading = np.ascontiguousarray(starts[:, 2])
    c, s = np.cos(heading), np.sin(heading)
    x, y = (ends - starts)[:, :2].T
    return np.column_stack([c * x + s * y, c * y - s * x,
                            wrap_angle(ends[:, 2] - starts[:, 2])])


def align_rigid(source, target):
    """The pose T that minimises sum |T source_i - target_i|^2; no scale, no reflection.

    Closed form in the plane (Umeyama 1991 without scale). Coinciding points give no rotation.
    """
    source, target = np.asarray(source, dtype=float), np.asarray(target, dtype=float)
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    dot = np.sum(a * b)
    cross = np.sum(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
    angle = float(np.arctan2(cross, dot))
    x, y = target.mean(axis=0) - rotation(angle) @ source.mean(axis=0)
    return np.array([x, y, angle])


def similarity_scale(source, target):
    """The scale s of the similarity that minimises sum |s R source_i + t - target_i|^2 (Umeyama 1991).

    None where it is not positive: the points coincide, or have nothing to do with one another.
    """
    source, target = np.asarray(source, dtype=float), np.asarray(target, dtype=float)
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    turned = b @ rotation(align_rigid(source, target)[2])
    overlap, size = float(np.sum(a * turned)), float(np.sum(a * a))
    return overlap / size if size > 0.0 and overlap > 0.0 else None
