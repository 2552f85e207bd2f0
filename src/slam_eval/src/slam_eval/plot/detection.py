# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heat maps of the detection rate."""
import numpy as np

from slam_eval.plot import style as look


def _draw(axes, name, distances, angles, rates):
    values = np.array([[np.nan if rate is None else rate for rate in row] for row in rates])
    picture = axes.imshow(values, origin="lower", aspect="auto", vmin=0.0, vmax=1.0,
                          cmap="YlGnBu")
    for (row, column), rate in np.ndenumerate(values):
        if np.isfinite(rate):
            axes.text(column, row, f"{100 * rate:.0f}", ha="center", va="center", fontsize=8,
                      color="white" if rate > 0.6 else look.TRUTH)
    axes.set_xticks(range(len(distances)), [f"{d:g}" for d in distances])
    axes.set_yticks(range(len(angles)), [f"{a:g}" for a in angles])
    axes.set_xlabel("distance [m]")
    axes.set_title(name, fontsize=10)
    axes.grid(False)
    return picture


def plot_detection_rates(grids, path):
    """Detection rate by detector: (distances [m], obliquenesses [deg], rates or None)."""
    with look.style():
        figure, panels = look.plt.subplots(1, len(grids), squeeze=False, sharey=True,
                                           figsize=(1.2 + 5.0 * len(grids), 3.8),
                                           constrained_layout=True)
        for axes, (name, grid) in zip(panels[0], grids.items()):
            picture = _draw(axes, name, *grid)
        panels[0][0].set_ylabel("obliqueness [deg]")
        bar = figure.colorbar(picture, ax=list(panels[0]), label="detection rate [%]",
                              ticks=[0.0, 0.5, 1.0], pad=0.02)
        bar.ax.set_yticklabels(["0", "50", "100"])
        bar.outline.set_visible(False)
        look.save(figure, path)
