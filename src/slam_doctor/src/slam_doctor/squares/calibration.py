# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far a camera's calibration is from the one that images of squares show.

Four corners are eight numbers, a pose has six: each square leaves two equations on the calibration
(Zhang 2000, section 2.3). Least squares over many squares, whose poses are eliminated, give the
change of focal lengths, principal point and first two radial coefficients with its covariance.
"""
import dataclasses

import numpy as np

from slam_doctor.squares import poses

# The six parameters of a change: ln of the focal length, ln of fx / fy, cx and cy as shares of the
# width, k1, k2. STEPS are those of the numeric derivative.
STEPS = np.array([1e-4, 1e-4, 1e-5, 1e-5, 1e-4, 1e-4])
PRIOR = np.array([0.3, 0.1, 0.15, 0.15, 0.4, 0.5])  # standard deviations of a bad calibration
ITERATIONS = 10
LEAST_SIGMA = 0.05  # of a corner: no detector is better throughout [px]
LEAST_SIDE = 30.0   # of a marker: of smaller ones noise looks like perspective [px]
HUBER = 2.0         # residuals beyond so many standard deviations count less
FALSE = 6.0         # a square with one beyond so many is none, once the calibration is about right
CELL = 0.05         # views of a marker are alike in such a cell of the image, share of the width
ZOOM = 0.2          # and within such a factor of the size (ln)
BORDER = 0.05       # the border is looked at so far within the image, share of its size
CLOSE = 0.005       # so far a good calibration is off near the border, share of the width
POINTS = 9          # on each side of it


@dataclasses.dataclass(frozen=True)
class Sighting:
    """A marker in an image."""

    id: int
    corners: np.ndarray  # 4 x 2, in the order in which the detector has them [px]


@dataclasses.dataclass(frozen=True)
class Fit:
    """What squares say about a calibration."""

    off: float           # how far the image of a ray near the border is off, at most [px]
    sigma: float         # standard deviation of it [px]
    least_off: float     # the same of the smallest change that explains the squares as well [px]
    chi_square: float    # of the change, of 6 degrees of freedom: by its covariance before and
                         # after, and by how much it lowers the sum of squares, the least of these
    corner_sigma: float  # of a corner [px]
    change: np.ndarray   # of the calibration, see STEPS


def changed(camera, change):
    """The Camera after a change."""
    half = np.array([0.5, -0.5]) * change[1]
    distortion = camera.distortion.copy()
    distortion[:2] += change[4:]
    return dataclasses.replace(camera, focal=camera.focal * np.exp(change[0] + half),
                               centre=camera.centre + camera.size[0] * change[2:4],
                               distortion=distortion)


def derivatives(camera, change, project):
    """Derivatives of project(camera) by the change, in a last dimension."""
    columns = [(project(changed(camera, change + step)) - project(changed(camera, change - step))) /
               (2 * step.sum()) for step in np.diag(STEPS)]
    return np.stack(columns, axis=-1)


def usable(sightings):
    """Those whose corners span a convex area that is large enough to say something."""
    return [each for each in sightings if smallest_turn(each.corners) > LEAST_SIDE ** 2 / 2]


def smallest_turn(corners):
    """The smallest area of the triangles that successive corners span [px^2]; negative where the
    corners do not go round a convex shape."""
    sides = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(sides, np.roll(sides, -1, axis=0)) / 2
    return float((turns * np.sign(turns.sum())).min())


def kinds_of_views(camera, sightings):
    """For each sighting the number of its kind: of the same marker, place and size."""
    corners = np.array([each.corners for each in sightings])
    ids = np.array([each.id for each in sightings])
    sides = np.linalg.norm(corners[:, 0] - corners[:, 2], axis=1)
    cells = np.c_[ids, np.floor(corners.mean(axis=1) / (CELL * camera.size[0])),
                  np.floor(np.log(np.maximum(sides, 1.0)) / ZOOM)]
    return np.unique(cells, axis=0, return_inverse=True)[1].reshape(-1)


class Equations:
    """Two equations for each square, linear in the change: y = A change + noise."""

    def __init__(self, camera, change, pose, corners):
        now = changed(camera, change)
        left = poses.residuals(now, pose, corners)
        J = poses.jacobian(now, pose)
        across = np.linalg.qr(J, mode="complete")[0][:, :, 6:]  # what no pose explains
        B = derivatives(camera, change, lambda other: poses.image(other, pose).reshape(-1, 8))
        self.y = np.einsum("nki,nk->ni", across, left)
        self.A = np.einsum("nki,nkj->nij", across, B)

    def sigma(self):
        """The noise of an equation, which is that of a corner's coordinate [px]."""
        return max(LEAST_SIGMA, 1.4826 * float(np.median(np.abs(self.y))))

    def are_squares(self):
        """For each whether it is a square as far as one can see."""
        return np.abs(self.y).max(axis=1) < FALSE * self.sigma()

    def weights(self, share):
        """Inverse variances (N x 2); share: of each square, 1 over its views of one kind."""
        sigma = self.sigma()
        huber = 1 / np.maximum(1, np.abs(self.y) / (HUBER * sigma))
        return huber * share[:, None] / sigma ** 2

    def information(self, weights):
        """That on the change, of equations with weights (N x 2) and of a prior near none."""
        return np.einsum("nki,nk,nkj->ij", self.A, weights, self.A) + np.diag(PRIOR ** -2)

    def step(self, change, share):
        """The step of the change towards the least squares."""
        w = self.weights(share)
        gradient = np.einsum("nki,nk,nk->i", self.A, w, self.y) - change / PRIOR ** 2
        return np.linalg.solve(self.information(w), gradient)

    def precision(self, share, markers):
        """The inverse covariance of the change. What is wrong with a marker, as a bent one, is
        wrong in all its views: the sandwich estimator of clusters is added."""
        information = self.information(self.weights(share))
        scores = np.einsum("nki,nk,nk->ni", self.A, self.weights(share), self.y)
        _, numbers = np.unique(markers, return_inverse=True)
        sums = np.zeros((numbers.max() + 1, scores.shape[1]))
        np.add.at(sums, numbers, scores)
        inverse = np.linalg.inv(information)
        spread = inverse @ (sums.T @ sums) @ inverse * len(sums) / max(1, len(sums) - 1)
        return np.linalg.inv(inverse + spread)


def fit(camera, sightings):
    """The Fit of a camera to sightings, of which it takes several markers in different views."""
    corners = np.array([each.corners for each in sightings])
    markers = np.array([each.id for each in sightings])
    kinds = kinds_of_views(camera, sightings)
    share = 1.0 / np.bincount(kinds)[kinds]
    none = np.zeros(len(STEPS))
    pose, left = poses.find(camera, corners)
    first = Equations(camera, none, pose, corners)
    change, pose = converge(camera, corners, share, pose)
    last = Equations(camera, change, pose, corners)
    share = share * last.are_squares()
    gain = (cost(left, share, last.sigma()) -
            cost(poses.residuals(changed(camera, change), pose, corners), share, last.sigma()))
    precision = last.precision(share, markers)
    # Noise may pretend a change by which the squares would tell more than they do without it.
    before = first.information(last.weights(share))
    return judged(camera, change, precision, last.sigma(),
                  [gain, float(change @ precision @ change), float(change @ before @ change)])


def converge(camera, corners, share, pose):
    """(change, poses) by the iterations of Gauss and Newton."""
    change = np.zeros(len(STEPS))
    for iteration in range(ITERATIONS):
        equations = Equations(camera, change, pose, corners)
        counted = share if iteration < ITERATIONS // 2 else share * equations.are_squares()
        change = change + equations.step(change, counted)
        pose, _ = poses.refine(changed(camera, change), pose, corners, 4)
    return change, pose


def cost(left, share, sigma):
    """The sum of squared residuals (N x 8) in units of sigma, large ones by Huber's norm."""
    ratio = np.linalg.norm(left, axis=1) / sigma
    values = np.where(ratio < HUBER, ratio ** 2, HUBER * (2 * ratio - HUBER))
    return float(share @ values)


def judged(camera, change, information, corner_sigma, chi_squares):
    """The Fit of a change with its information and several measures of its significance."""
    pixels = border(camera)
    rays = camera.rays(pixels)
    is_image = np.isfinite(rays).all(axis=1)
    pixels, rays = pixels[is_image], rays[is_image]
    J = derivatives(camera, change, lambda other: other.image(rays))  # N x 2 x 6
    # The least change: of those that fit the squares, the one with which the border fits as well.
    fits = np.einsum("nki,nkj->ij", J, J) / (len(J) * (CLOSE * camera.size[0]) ** 2)
    least = np.linalg.solve(information + fits, information @ change)
    off, worst = largest_shift(camera, change, pixels, rays)
    spread = J[worst] @ np.linalg.solve(information, J[worst].T)
    return Fit(off, float(np.sqrt(np.linalg.eigvalsh(spread)[-1])),
               largest_shift(camera, least, pixels, rays)[0],
               min(chi_squares), corner_sigma, change)


def border(camera):
    """Pixels (N x 2) near the border of the image."""
    line = np.linspace(BORDER, 1 - BORDER, POINTS)
    low, high = np.full(POINTS, BORDER), np.full(POINTS, 1 - BORDER)
    sides = [np.c_[line, low], np.c_[line, high], np.c_[low, line], np.c_[high, line]]
    return np.concatenate(sides) * np.array(camera.size)


def largest_shift(camera, change, pixels, rays):
    """(distance, number of the pixel) of the pixel that a change moves most [px]."""
    distances = np.linalg.norm(changed(camera, change).image(rays) - pixels, axis=1)
    return float(distances.max()), int(distances.argmax())
