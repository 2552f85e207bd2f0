# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a campaign: the values of all runs, and the paths of each product on a bag."""
import numpy as np

from slam_eval.geometry import se2
from slam_eval.metrics.evaluation import trajectory_error
from slam_eval.plot import plan, style as look

_COLUMNS = 3
_WIDE = 10.5  # [inch]
_SPREAD = 20.0  # largest over smallest value from which an axis is logarithmic


def _strip(axes, values):
    """values: by product a list of numbers. Dots, and a line at the median."""
    for place, numbers in enumerate(values.values()):
        if not numbers:
            axes.text(0.02, place, "no value", transform=axes.get_yaxis_transform(), va="center",
                      color=look.MUTED, fontsize=8)
            continue
        # Spread across, so that equal values can be counted.
        offsets = np.linspace(-0.18, 0.18, len(numbers)) if len(numbers) > 1 else [0.0]
        axes.plot(sorted(numbers), place + np.asarray(offsets), "o", color=look.ESTIMATE,
                  markersize=4, alpha=0.75, zorder=3)
        axes.vlines(np.median(numbers), place - 0.32, place + 0.32, color=look.ERROR, linewidth=1.8,
                    zorder=4)
    axes.set_ylim(len(values) - 0.5, -0.5)
    known = [number for numbers in values.values() for number in numbers]
    if known and min(known) > 0.0 and max(known) / min(known) > _SPREAD:
        axes.set_xscale("log")
    axes.margins(x=0.08)


def plot_values(bags, label, path):
    """A panel for each bag. bags: by bag and product a list of numbers; label: of the axis."""
    columns = min(len(bags), _COLUMNS)
    rows = -(-len(bags) // columns)
    products = list(next(iter(bags.values())))
    height = rows * (0.9 + 0.27 * len(products))
    with look.style():
        figure, grid = look.plt.subplots(rows, columns, squeeze=False, sharey=True,
                                         figsize=(_WIDE, height), constrained_layout=True)
        for axes in grid.flat[len(bags):]:
            axes.axis("off")
        for axes, (bag, values) in zip(grid.flat, bags.items()):
            _strip(axes, values)
            axes.set_yticks(range(len(products)), products)
            axes.set_title(bag, fontsize=10)
            axes.set_xlabel(label, fontsize=8.5)
            look.plain(axes)
        look.save(figure, path)


def _draw_run(axes, run):
    estimate = run.trajectory.poses
    if run.truth is not None:
        error = trajectory_error(run.trajectory, run.truth)
        start, end = run.trajectory.stamps[[0, -1]]
        during = (run.truth.stamps >= start) & (run.truth.stamps <= end)
        axes.plot(*run.truth.poses[during, :2].T, color=look.TRUTH, linewidth=2.0, alpha=0.35)
        if error is not None:
            estimate = se2.transform_poses(error.T_truth_map, estimate)
    plan.draw_path(axes, run.trajectory.stamps, estimate[:, :2], color=look.ESTIMATE, linewidth=0.9,
                   zorder=3)


def plot_paths(runs, path):
    """A panel for each product on one bag: its path, moved onto the true one. runs: by product a
    run that was read, or None where there is none."""
    columns = min(len(runs), _COLUMNS + 1)
    rows = -(-len(runs) // columns)
    with look.style():
        figure, grid = look.plt.subplots(rows, columns, squeeze=False, constrained_layout=True,
                                         figsize=(_WIDE, 2.5 * rows))
        for axes in grid.flat[len(runs):]:
            axes.axis("off")
        for axes, (product, run) in zip(grid.flat, runs.items()):
            if run is None:
                axes.text(0.5, 0.5, "no run", transform=axes.transAxes, ha="center",
                          color=look.MUTED)
                axes.set_xticks([])
                axes.set_yticks([])
            else:
                _draw_run(axes, run)
            axes.set_aspect("equal", adjustable="datalim")
            axes.tick_params(labelsize=7)
            axes.set_title(product, fontsize=9)
            look.plain(axes)
        look.save(figure, path)
