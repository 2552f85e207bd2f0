# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which landmark was taken for which: pairings as lines, wrong ones in red."""
import numpy as np

from slam_eval.plot import style as look

MOST = 4000  # right pairings that are drawn


def _ends(run, rows):
    """Robot and landmark of each row that was paired, where both are known."""
    places = dict(zip(run.landmarks.ids, run.landmarks.positions))
    poses = dict(zip(run.trajectory.stamps.tolist(), run.trajectory.poses[:, :2]))
    return {number: (poses[row.stamp], places[row.landmark]) for number, row in enumerate(rows)
            if row.taken_for == "landmark" and row.landmark in places and row.stamp in poses}


def plot_associations(run, rows, wrong, path):
    """Lines from the robot to the landmarks of its observations; wrong: numbers of rows."""
    ends = _ends(run, rows)
    right = [pair for number, pair in ends.items() if number not in set(wrong)]
    right = right[::max(1, len(right) // MOST)]
    with look.style():
        points = np.vstack([run.trajectory.poses[:, :2], run.landmarks.positions])
        figure, axes = look.plan_axes(points)
        for pairs, colour, width in ((right, "0.8", 0.3),
                                     ([ends[n] for n in wrong if n in ends], "red", 0.9)):
            for robot, landmark in pairs:
                axes.plot(*np.transpose([robot, landmark]), color=colour, linewidth=width)
        axes.plot(*run.trajectory.poses[:, :2].T, color="black", linewidth=0.6)
        axes.plot(*run.landmarks.positions.T, "k^", markersize=3)
        axes.set_title(f"Association · {run.title}: {len(wrong)} wrong (red)")
        look.save(figure, path)
