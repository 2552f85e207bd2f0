# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""map.png and trajectory.png: the thesis's figures 6.2a and 6.2b with the truth beside them."""
import numpy as np

from slam_eval.plot import plan
from slam_eval.plot import style as look


def _finish(figure, axes, title, errors, path):
    known = [f"{name} {error.rmse:.3f} m" for name, error in errors.items() if error is not None]
    axes.set_title(title)
    look.remark(axes, " · ".join(known))
    look.legend_below(figure, axes, columns=5)
    look.save(figure, path)


def plot_map(run, result, path, reference="ground truth", world=None):
    """Figure 6.2a: the path and the landmarks with their 95 % ellipses and ids, in a WorldPlan;
    the grid and the points of a laser under them."""
    estimate, landmarks = run.trajectory.poses[:, :2], run.landmarks
    grid = run.grid and run.grid.known_part()
    has_landmarks = landmarks is not None and len(landmarks.ids) > 0
    truth, true = plan.truth_in_map(run, result), plan.true_landmarks_in_map(run, result)
    world = plan.world_in_map(world, result)
    with look.style():
        points = plan.bounds(estimate, truth, true, landmarks.positions if has_landmarks else None,
                             landmarks.lines.reshape(-1, 2) if landmarks is not None else None,
                             run.points, plan.grid_corners(grid), world=world)
        span = float(np.max(np.ptp(points, axis=0)))
        scale = plan.magnification(landmarks, [], span, 0.03) if has_landmarks else 1
        figure, axes = look.plan_axes(plan.bounds(points, *plan.extent(landmarks, scale)))
        plan.draw_grid(axes, grid)
        plan.draw_world(axes, world, filled=grid is None)
        plan.draw_points(axes, run.points)
        plan.draw_estimate(axes, run)
        plan.draw_truth(axes, truth, reference)
        if has_landmarks:
            plan.draw_landmarks(axes, landmarks, scale, run.labels)
        plan.draw_lines(axes, landmarks)
        plan.draw_true_landmarks(axes, true)
        _finish(figure, axes, f"Path and map · {run.title}",
                {"ATE": result.ate, "landmarks": result.landmark_error}, path)


def plot_trajectory(run, result, path, reference="ground truth", world=None):
    """Figure 6.2b: the path of SLAM against that of dead reckoning, in a WorldPlan."""
    truth, odometry = plan.truth_in_map(run, result), plan.odometry_in_map(run)
    world = plan.world_in_map(world, result)
    with look.style():
        figure, axes = look.plan_axes(plan.bounds(run.trajectory.poses[:, :2], truth, odometry,
                                                  world=world))
        plan.draw_world(axes, world)
        if odometry is not None:
            plan.draw_path(axes, run.odometry.stamps, odometry, color=look.ODOMETRY,
                           linewidth=1.3, zorder=2, label="dead reckoning")
        plan.draw_estimate(axes, run)
        plan.draw_truth(axes, truth, reference)
        _finish(figure, axes, f"Paths · {run.title}",
                {"ATE of SLAM": result.ate, "of dead reckoning": result.odometry_ate}, path)
