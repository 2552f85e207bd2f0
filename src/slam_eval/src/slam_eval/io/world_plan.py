# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Walls, furniture and trees of a simulated world (slam_sim's world file), to be drawn behind a map
and to hold it against."""
import dataclasses

import numpy as np
import yaml

from slam_eval.geometry import se2
from slam_eval.geometry.surfaces import Surfaces
from slam_eval.io.errors import InputError, read_text

_CEILING = 2.5  # [m], where the file does not say
_CORNERS = 16   # of a trunk's outline


@dataclasses.dataclass
class WorldPlan:
    """Lines of walls and outlines of furniture and trunks (each N x 2) [m], in the frame of the
    truth."""

    walls: list
    furniture: list
    wall_heights: list = dataclasses.field(default_factory=list)       # [m]
    furniture_heights: list = dataclasses.field(default_factory=list)  # [m]

    def surfaces(self, height):
        """What stands at least so high [m], as a laser of that height sees it."""
        lines = [line for line, top in zip(self.walls, self.wall_heights) if top >= height]
        lines += [np.vstack([outline, outline[:1]])
                  for outline, top in zip(self.furniture, self.furniture_heights) if top >= height]
        segments = [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
        return Surfaces(np.vstack(segments) if segments else np.empty((0, 2, 2)))


def _wall(entry):
    points = np.array(entry["points"], dtype=float).reshape(-1, 2)
    return np.vstack([points, points[:1]]) if entry.get("closed") else points


def _outline(entry):
    centre, yaw = np.array(entry["centre"], dtype=float), float(entry.get("yaw", 0.0))
    corners = 0.5 * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.array(
        entry["size"][:2], dtype=float)
    return se2.transform_points((*centre, yaw), corners)


def _trunk(entry):
    angles = np.linspace(0.0, 2.0 * np.pi, _CORNERS, endpoint=False)
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    return np.array(entry["centre"], dtype=float) + float(entry["radius"]) * circle


def read_world(path):
    """Read the plan of a world file. Raises InputError."""
    try:
        document = yaml.safe_load(read_text(path))
        walls, furniture, trees = (document.get(key) or []
                                   for key in ("walls", "furniture", "trees"))
        ceiling = float((document.get("ceiling") or {}).get("height", _CEILING))
        return WorldPlan([_wall(entry) for entry in walls],
                         [_outline(entry) for entry in furniture] + [_trunk(tree) for tree in trees],
                         [float(entry.get("height", ceiling)) for entry in walls],
                         [float(entry["size"][2]) for entry in furniture] + [ceiling] * len(trees))
    except (yaml.YAMLError, AttributeError, KeyError, IndexError, TypeError, ValueError):
        raise InputError(f"{path}: holds no walls and furniture as a world file of slam_sim does; "
                         "give the world that the log was simulated in") from None
