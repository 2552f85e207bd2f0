# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""landmark_errors.png: do the errors of the landmarks fit their ellipses?"""
import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.landmarks import match_by_id
from slam_eval.plot import plan
from slam_eval.plot import style as look


def plot_landmark_errors(run, result, path):
    """Landmarks, their ellipses and their errors, all magnified alike.

    Returns False where there is no landmark error.
    """
    if result.landmark_error is None:
        return False
    landmarks = run.landmarks
    T = se2.inverse(result.landmark_error.T_truth_map)
    _, starts, matched = match_by_id(landmarks, run.true_landmarks)
    offsets = se2.transform_points(T, matched) - starts
    true = se2.transform_points(T, run.true_landmarks.positions)
    with look.style():
        points = plan.bounds(landmarks.positions, true)
        span = float(np.max(np.ptp(points, axis=0)))
        scale = plan.magnification(landmarks, np.linalg.norm(offsets, axis=1), span)
        figure, axes = look.plan_axes(plan.bounds(points, *plan.extent(landmarks, scale)))
        plan.draw_true_landmarks(axes, true)
        look.draw_segments(axes, starts, starts + scale * offsets, color=look.ERROR,
                           linewidth=1.6, zorder=6.5, label="error" + plan.larger(scale))
        plan.draw_landmarks(axes, landmarks, scale)
        axes.set_title(f"Landmarks · {run.title} · {len(landmarks)} of them, "
                       f"RMSE {result.landmark_error.rmse:.4f} m")
        look.legend_below(figure, axes, columns=2)
        look.save(figure, path)
    return True
