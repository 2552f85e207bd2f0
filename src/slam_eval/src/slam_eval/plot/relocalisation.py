# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where robots were switched on in a map, and which of them were found."""
from slam_eval.plot import plan
from slam_eval.plot import style as look

COLOURS = {"right": look.LANDMARK, "did not know": look.MUTED, "wrong": look.ERROR}


def plot_starts(title, run, truth, places, outcomes, path):
    """The map of a run, the way (a trajectory) and the places (N x 3) in the colour of what became
    of the robot: right, did not know, wrong."""
    grid = run.grid and run.grid.known_part()
    marks = run.landmarks
    positions = marks.positions if marks is not None and len(marks) > 0 else None
    with look.style():
        points = plan.bounds(truth.poses[:, :2], positions, plan.grid_corners(grid))
        figure, axes = look.plan_axes(points)
        plan.draw_grid(axes, grid)
        axes.plot(*truth.poses[:, :2].T, color="0.75", linewidth=0.6, zorder=1, label="way")
        if positions is not None:
            axes.plot(*positions.T, "k^", markersize=3, zorder=2, label="landmark")
        for outcome, colour in COLOURS.items():
            chosen = [pose for pose, was in zip(places, outcomes) if was == outcome]
            if chosen:
                axes.plot([p[0] for p in chosen], [p[1] for p in chosen], "o", color=colour,
                          markersize=4.5, zorder=3, label=f"{outcome}: {len(chosen)}")
        axes.set_title(title)
        look.legend_below(figure, axes, columns=6)
        look.save(figure, path)
