# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Walls and furniture of a simulated world (slam_sim's world file), to be drawn behind a map."""
import dataclasses

import numpy as np
import yaml

from slam_eval.errors import InputError, read_text


@dataclasses.dataclass
class WorldPlan:
    """Lines of walls and outlines of furniture (each N x 2) [m], in the frame of the truth."""

    walls: list
    furniture: list


def _wall(entry):
    points = np.array(entry['points'], dtype=float).reshape(-1, 2)
    return np.vstack([points, points[:1]]) if entry.get('closed') else points


def _outline(entry):
    centre, yaw = np.array(entry['centre'], dtype=float), float(entry.get('yaw', 0.0))
    corners = 0.5 * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.array(
        entry['size'][:2], dtype=float)
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    return corners @ turn.T + centre


def read_world(path):
    """Read the plan of a world file. Raises InputError."""
    try:
        document = yaml.safe_load(read_text(path))
        return WorldPlan([_wall(entry) for entry in document.get('walls') or []],
                         [_outline(entry) for entry in document.get('furniture') or []])
    except (yaml.YAMLError, AttributeError, KeyError, IndexError, TypeError, ValueError):
        raise InputError(f'{path}: holds no walls and furniture as a world file of slam_sim does; '
                         'give the world that the log was simulated in') from None
