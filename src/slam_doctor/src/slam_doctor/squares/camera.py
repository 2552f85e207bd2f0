# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A camera as its camera_info describes it (slam_core/camera/lens.cpp has the same models)."""
import dataclasses

import numpy as np

COEFFICIENTS = 8
ITERATIONS = 30  # of the inverse, which need not converge: who uses it refines


@dataclasses.dataclass(frozen=True)
class Camera:
    """Focal lengths and principal point [px], and distortion coefficients."""

    focal: np.ndarray   # fx, fy
    centre: np.ndarray  # cx, cy
    distortion: np.ndarray  # k1, k2, p1, p2, k3, ... ; equidistant: k1 to k4
    size: tuple         # width, height [px]
    is_equidistant: bool = False

    def image(self, points):
        """Pixels (... x 2) of points in the plane z = 1 (... x 2)."""
        distort = equidistant if self.is_equidistant else polynomial
        return distort(points, self.distortion) * self.focal + self.centre

    def rays(self, pixels):
        """Points in the plane z = 1 whose images pixels (... x 2) are, by fixed-point iteration."""
        distorted = (pixels - self.centre) / self.focal
        points = distorted
        if self.is_equidistant:
            theta = np.linalg.norm(distorted, axis=-1, keepdims=True)
            points = distorted * np.tan(np.minimum(theta, 1.5)) / np.maximum(theta, 1e-9)
        for _ in range(ITERATIONS):
            points = points - (self.image(points) - pixels) / self.focal
        return points


def camera_of(info):
    """The Camera of a sensor_msgs/CameraInfo."""
    coefficients = np.zeros(COEFFICIENTS)
    coefficients[:len(info.D)] = info.D[:COEFFICIENTS]
    return Camera(np.array([info.K[0], info.K[4]]), np.array([info.K[2], info.K[5]]), coefficients,
                  (info.width, info.height), info.distortion_model == "equidistant")


def polynomial(points, coefficients):
    """plumb_bob and rational_polynomial."""
    k1, k2, p1, p2, k3, k4, k5, k6 = coefficients
    x, y = points[..., 0], points[..., 1]
    s = x * x + y * y
    c = (1 + s * (k1 + s * (k2 + s * k3))) / (1 + s * (k4 + s * (k5 + s * k6)))
    return np.stack([x * c + 2 * p1 * x * y + p2 * (s + 2 * x * x),
                     y * c + p1 * (s + 2 * y * y) + 2 * p2 * x * y], axis=-1)


def equidistant(points, coefficients):
    """equidistant, of fisheye lenses."""
    k1, k2, k3, k4 = coefficients[:4]
    radius = np.maximum(np.linalg.norm(points, axis=-1, keepdims=True), 1e-12)
    theta = np.arctan(radius)
    s = theta * theta
    return points / radius * theta * (1 + s * (k1 + s * (k2 + s * (k3 + s * k4))))
