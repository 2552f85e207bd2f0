# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths of odometries beside the true one (the thesis's figure 6.6)."""
import numpy as np

from slam_eval import plot_style as look
from slam_eval import se2

_COLOURS = (look.ESTIMATE, look.ODOMETRY, look.LANDMARK)


def plot_odometry(truth, tracks, path):
    """truth: poses (N x 3); tracks: poses by name, each moved so that it starts where truth does."""
    truth = np.asarray(truth, dtype=float)
    with look.style():
        figure, axes = look.plt.subplots(figsize=(7.2, 6.0), constrained_layout=True)
        axes.plot(*truth[:, :2].T, color=look.TRUTH, linewidth=1.0, linestyle=(0, (4, 4)), zorder=4,
                  label='truth')
        for colour, (name, poses) in zip(_COLOURS, tracks.items()):
            poses = np.asarray(poses, dtype=float)
            moved = se2.transform_poses(se2.compose(truth[0], se2.inverse(poses[0])), poses)
            axes.plot(*moved[:, :2].T, color=colour, linewidth=1.8, label=name)
        axes.plot(*truth[0, :2], 'o', color='white', markeredgecolor=look.TRUTH, zorder=5,
                  label='start')
        axes.set_aspect('equal')
        axes.set_xlabel('x [m]')
        axes.set_ylabel('y [m]')
        axes.legend(loc='best', fontsize=9)
        look.save(figure, path)
