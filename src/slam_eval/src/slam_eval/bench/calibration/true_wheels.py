# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a calibration of the simulator's wheels should find: they are systematically off, beside
what a case does to them."""
import dataclasses

import numpy as np

from slam_eval.geometry import se2


@dataclasses.dataclass(frozen=True)
class TrueWheels:
    """Scale: true over measured way; base: true over believed distance of the wheels; drift: a turn
    on the way that they do not measure [rad/m]."""

    scale: float
    base: float
    drift: float


def measured_by(wheels):
    """The matrix that makes the motion (way, turn) that wheels measure of the true one, without
    noise. wheels: of a robot file of slam_sim, with two wheels."""
    lever, believed = wheels["lever"], wheels["lever"] * wheels["lever_scale"]
    left, right = wheels["wheel_scales"]
    ways = np.array([[left, -left * lever / 2.0], [right, right * lever / 2.0]])
    return np.array([[0.5, 0.5], [-1.0 / believed, 1.0 / believed]]) @ ways


def _motions(poses):
    """(way [m], turn [rad]) of each step of a path."""
    steps = se2.relative(poses[:-1], poses[1:])
    half = se2.wrap_angle(steps[:, 2]) / 2.0
    way = (steps[:, 0] * np.cos(half) + steps[:, 1] * np.sin(half)) / np.sinc(half / np.pi)
    return np.column_stack([way, 2.0 * half])


def true_wheels(wheels, poses):
    """The TrueWheels of a drive, by its true poses (N x 3).

    The true turn is exactly a share of the measured turn and a share of the measured way. The true
    way also depends on the turn a little, where one wheel is larger than the other, for which the
    parameters have no room: the scale is that which fits the whole drive best.
    """
    matrix, motions = measured_by(wheels), _motions(poses)
    measured = motions @ matrix.T
    scale = float(motions[:, 0] @ measured[:, 0] / (measured[:, 0] @ measured[:, 0]))
    by_way, by_turn = np.linalg.inv(matrix)[1]
    return TrueWheels(scale, float(scale / by_turn), float(by_way / scale))
