# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The laser of a simulated robot, as slam_sim's robot files describe it."""
import dataclasses
import pathlib

import numpy as np
import yaml

from slam_eval.io.errors import InputError, read_text


@dataclasses.dataclass
class Laser:
    """The simulated robot's laser: on the robot (x, y, yaw), height, half its view and reach."""

    pose: np.ndarray
    height: float
    half_view: float
    reach: float


def read_simulated_laser(world_file, robot):
    """The laser of the simulated robot that has this robot file, or None.

    The robots of a simulation stand beside its worlds, in ../robots.
    """
    folder = pathlib.Path(world_file).resolve().parent.parent / "robots"
    for path in sorted(folder.glob("*.yaml")):
        try:
            document = yaml.safe_load(read_text(path))
            if not isinstance(document, dict) or document.get("robot") != robot:
                continue
            laser = document["laser"]
            x, y, z = map(float, laser["position"])
            return Laser(np.array([x, y, float(laser.get("yaw", 0.0))]), z,
                         0.5 * float(laser["field_of_view"]), float(laser["max_range"]))
        except (yaml.YAMLError, KeyError, TypeError, ValueError):
            raise InputError(f"{path}: holds no laser as a robot of slam_sim does") from None
    return None
