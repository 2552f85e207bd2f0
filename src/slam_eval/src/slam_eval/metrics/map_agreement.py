# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How well a grid or a point map agrees with the walls of a simulated world."""
import dataclasses
from typing import Optional

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.grid_map import OCCUPIED
from slam_eval.io.simulated_laser import read_simulated_laser
from slam_eval.io.trajectory import interpolate

_NEAR_WALL = 0.3    # [m]: a point further from every wall belongs to none
_LEAST_POINTS = 20  # of a wall whose thickness can be told
_BAND = 5, 95       # percentiles that bound a wall's thickness
_POSES_APART = 0.1  # [m]: from where it is told what can be seen


@dataclasses.dataclass
class MapAgreement:
    """Shares of cells on walls and of walls in cells [0..1], thickness and error of points [m]."""

    occupied_on_walls: Optional[float] = None
    walls_found: Optional[float] = None
    wall_thickness: Optional[float] = None
    wall_error: Optional[float] = None

    @property
    def metrics(self):
        """The keys of metrics.json."""
        percent = {"map_cells_on_walls_percent": self.occupied_on_walls,
                   "map_walls_found_percent": self.walls_found}
        values = {key: None if share is None else 100.0 * share for key, share in percent.items()}
        values["points_wall_thickness_m"] = self.wall_thickness
        values["points_wall_error_m"] = self.wall_error
        return {key: value for key, value in values.items() if value is not None}


def path_alignment(run):
    """The map in the frame of the truth, by a rigid fit of the path that the map was made on; or
    None where fewer than two of its poses have truth.

    One pose alone, like the first, would put its own error of heading into every wall.
    """
    path = run.final or run.trajectory
    true, valid = interpolate(run.truth, path.stamps)
    if np.count_nonzero(valid) < 2:
        return None
    return se2.align_rigid(path.poses[valid, :2], true[valid, :2])


def _is_near(points, others, distance):
    """Which points have one of the others within a distance [m]: by a hash of squares."""
    squares = {}
    for x, y in np.asarray(others):
        squares.setdefault((int(np.floor(x / distance)), int(np.floor(y / distance))),
                           []).append((x, y))
    near = np.zeros(len(points), bool)
    for i, (x, y) in enumerate(points):
        column, row = int(np.floor(x / distance)), int(np.floor(y / distance))
        around = [p for dc in (-1, 0, 1) for dr in (-1, 0, 1)
                  for p in squares.get((column + dc, row + dr), ())]
        near[i] = any((x - a) ** 2 + (y - b) ** 2 <= distance ** 2 for a, b in around)
    return near


def cells_on_walls(grid, surfaces, T_truth_map):
    """Share of the occupied cells whose centre is at most one cell from a true surface, or None."""
    centres = se2.transform_points(T_truth_map, grid.centres(OCCUPIED))
    if not len(centres):
        return None
    return float(np.mean(np.abs(surfaces.nearest(centres)[1]) <= grid.resolution))


def walls_found(grid, seen, T_truth_map):
    """Share of the true surface that was seen with an occupied cell at most one cell away."""
    if not len(seen):
        return None
    centres = se2.transform_points(T_truth_map, grid.centres(OCCUPIED))
    return float(np.mean(_is_near(seen, centres, grid.resolution)))


def apart(poses, distance=_POSES_APART):
    """Poses of a path that lie at least so far [m], or 0.2 rad, from the one before."""
    kept = [poses[0]]
    for pose in poses[1:]:
        turn = abs(se2.wrap_angle(pose[2] - kept[-1][2]))
        if np.hypot(*(pose - kept[-1])[:2]) >= distance or turn >= 0.2:
            kept.append(pose)
    return np.array(kept)


def wall_thickness(points, surfaces, T_truth_map):
    """(thickness, RMS distance) [m] of walls in a point map, or (None, None).

    The thickness is the width of the band that holds the middle 90 % of a wall's points, averaged
    over the walls by their points.
    """
    index, signed = surfaces.nearest(se2.transform_points(T_truth_map, points))
    near = np.abs(signed) <= _NEAR_WALL
    widths, weights = [], []
    for wall in np.unique(index[near]):
        offsets = signed[near & (index == wall)]
        if len(offsets) >= _LEAST_POINTS:
            low, high = np.percentile(offsets, _BAND)
            widths.append(high - low)
            weights.append(len(offsets))
    if not widths:
        return None, None
    return (float(np.average(widths, weights=weights)),
            float(np.sqrt(np.mean(signed[near] ** 2))))


def map_agreement(run, surfaces, laser):
    """MapAgreement of a run whose world is known, or None where nothing can be told."""
    if run.truth is None or (run.grid is None and run.points is None):
        return None
    T = path_alignment(run)
    if T is None:
        return None
    result = MapAgreement()
    if run.grid is not None:
        result.occupied_on_walls = cells_on_walls(run.grid, surfaces, T)
        true, valid = interpolate(run.truth, run.trajectory.stamps)
        if laser is not None:
            seen = surfaces.seen_from(apart(true[valid]), laser)
            result.walls_found = walls_found(run.grid, seen, T)
    if run.points is not None and len(run.points):
        result.wall_thickness, result.wall_error = wall_thickness(run.points, surfaces, T)
    return result


def judge_map(run, world, world_file):
    """MapAgreement with a simulated world, or None."""
    if world is None:
        return None
    laser = read_simulated_laser(world_file, run.config.get("robot"))
    return map_agreement(run, world.surfaces(laser.height if laser else 0.0), laser)
