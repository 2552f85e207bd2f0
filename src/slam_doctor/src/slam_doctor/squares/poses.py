# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses of many squares at once, each from the images of its four corners.

The edge of a square is 1: its size changes its distance and no pixel. A pose is a rotation
(N x 3 x 3) and a position (N x 3) in the camera's optical frame.
"""
import numpy as np

CORNERS = np.array([[-0.5, 0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, -0.5]])
STEP = 1e-6  # of numeric derivatives [1, rad]


def rotation(vectors):
    """Rotations (N x 3 x 3) about vectors (N x 3 or 3) by their lengths [rad] (Rodrigues)."""
    x, y, z = np.moveaxis(np.atleast_2d(vectors), -1, 0)
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(-1, 3, 3)
    angle = np.maximum(np.sqrt(x * x + y * y + z * z), 1e-12)[:, None, None]
    return (np.eye(3) + np.sin(angle) / angle * cross +
            (1 - np.cos(angle)) / angle ** 2 * cross @ cross)


def image(camera, pose):
    """The corners' pixels (N x 4 x 2)."""
    turned, position = pose
    points = np.einsum("nij,kj->nki", turned[:, :, :2], CORNERS) + position[:, None]
    return camera.image(points[..., :2] / points[..., 2:])


def residuals(camera, pose, corners):
    """Observed minus projected corners (N x 8) [px]."""
    return (corners - image(camera, pose)).reshape(-1, 8)


def moved(pose, steps):
    """Poses changed by steps (N x 6): a rotation in the square's frame, then a shift."""
    return pose[0] @ rotation(steps[..., :3]), pose[1] + steps[..., 3:]


def jacobian(camera, pose):
    """Derivatives of the corners' pixels by the steps of moved() (N x 8 x 6)."""
    columns = [(image(camera, moved(pose, step)) - image(camera, moved(pose, -step))) / (2 * STEP)
               for step in STEP * np.eye(6)]
    return np.stack([column.reshape(-1, 8) for column in columns], axis=-1)


def first_guess(camera, corners):
    """Poses from the homographies of the undistorted corners (Zhang 2000, section 3.1)."""
    rays, turned, positions = camera.rays(corners), [], []
    for square in np.nan_to_num(rays):
        rows = []
        for (a, b), (u, v) in zip(CORNERS, square):
            rows += [[a, b, 1, 0, 0, 0, -u * a, -u * b, -u],
                     [0, 0, 0, a, b, 1, -v * a, -v * b, -v]]
        h = np.linalg.svd(np.array(rows))[2][-1].reshape(3, 3)
        h = h * (np.sign(h[2, 2]) or 1.0) * 2 / max(np.linalg.norm(h[:, :2], axis=0).sum(), 1e-12)
        left, _, right = np.linalg.svd(np.c_[h[:, :2], np.cross(h[:, 0], h[:, 1])])
        turned.append(left @ np.diag([1, 1, np.linalg.det(left @ right)]) @ right)
        positions.append(h[:, 2])
    return np.array(turned), np.array(positions)


def other_guess(pose):
    """The poses that look nearly the same (Schweighofer, Pinz 2006): the normal mirrored at the
    line of sight."""
    sight = pose[1] / np.linalg.norm(pose[1], axis=1, keepdims=True)
    return rotation(np.pi * sight) @ pose[0] @ np.diag([-1.0, -1.0, 1.0]), pose[1]


def refine(camera, pose, corners, iterations=25):
    """(poses, residuals) with the least squares of the residuals (Levenberg, Marquardt)."""
    damping = np.full(len(corners), 1e-4)
    left = residuals(camera, pose, corners)
    for _ in range(iterations):
        J = jacobian(camera, pose)
        A = np.einsum("nki,nkj->nij", J, J)
        A += damping[:, None, None] * np.einsum("nii->ni", A)[:, :, None] * np.eye(6)
        g = np.einsum("nki,nk->ni", J, left)
        tried = moved(pose, np.linalg.solve(A, g[..., None])[..., 0])
        after = residuals(camera, tried, corners)
        better = ((after ** 2).sum(axis=1) < (left ** 2).sum(axis=1)) & (tried[1][:, 2] > 0)
        pose, left = select(better, tried, pose), np.where(better[:, None], after, left)
        damping = np.where(better, damping / 5, damping * 10)
    return pose, left


def select(chosen, pose, other):
    """The poses where chosen (N), else the other ones."""
    return (np.where(chosen[:, None, None], pose[0], other[0]),
            np.where(chosen[:, None], pose[1], other[1]))


def find(camera, corners):
    """(poses, residuals) of squares, the better of both poses that explain each."""
    first, left = refine(camera, first_guess(camera, corners), corners)
    second, others = refine(camera, other_guess(first), corners)
    better = (others ** 2).sum(axis=1) < (left ** 2).sum(axis=1)
    return select(better, second, first), np.where(better[:, None], others, left)
