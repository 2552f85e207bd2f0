# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""consistency.png: do the errors fit what the filter says of itself?"""
import numpy as np

from slam_eval.io.trajectory import NANOSECONDS
from slam_eval.metrics.chi_square import chi_square_quantile, two_sided_bounds
from slam_eval.metrics.evaluation import inside_bounds
from slam_eval.plot import style as look

_BAND = np.sqrt(chi_square_quantile(0.95, 1))  # of a normal variable, in sigmas


def _panel(axes, title, remark):
    axes.set_title(title, fontsize=10)
    look.remark(axes, remark)
    look.plain(axes)
    axes.margins(x=0.01)


def _error_panel(axes, t, error, sigma, title, unit):
    band = _BAND * sigma
    axes.fill_between(t, -band, band, color=look.BAND, alpha=0.16, linewidth=0)
    axes.plot(*look.with_gaps(t, error), color=look.ESTIMATE, linewidth=0.9, marker=".",
              markersize=1.6)
    inside = np.mean(np.abs(error) <= band)
    _panel(axes, f"{title} [{unit}]", f"{100 * inside:.0f} % inside the 95 % band")
    limit = 1.12 * max(np.max(np.abs(error)), np.percentile(band, 98), 1e-9)
    axes.set_ylim(-limit, limit)


def _running_mean(values, weights, window):
    kernel = np.ones(min(window, len(values)))
    return np.convolve(values, kernel, "same") / np.maximum(np.convolve(weights, kernel, "same"),
                                                            1e-12)


def _scatter(axes, t, values, inside):
    for chosen, colour in ((inside, look.ESTIMATE), (~inside, look.ERROR)):
        axes.plot(t[chosen], values[chosen], ".", color=colour, markersize=2.4, alpha=0.55)


def _quadratic_panel(axes, t, values, dof, title, expected):
    """NEES or NIS, scaled to the expected value, with the bounds of the most frequent dof."""
    usual = int(np.bincount(dof).argmax())
    low, high = np.array(two_sided_bounds(usual)) * (expected / usual)
    floor = low / 8.0
    axes.axhspan(low, high, color=look.LANDMARK, alpha=0.13, linewidth=0)
    axes.axhline(expected, color=look.LANDMARK, linewidth=1.0)
    inside = inside_bounds(values * dof / expected, dof)
    # Points under the edge of the picture are drawn on it.
    _scatter(axes, t, np.maximum(values, 1.2 * floor), inside)
    mean = _running_mean(values * dof, dof.astype(float), max(len(t) // 60, 5))
    axes.plot(*look.with_gaps(t, mean), color=look.TRUTH, linewidth=1.2)
    axes.set_yscale("log")
    axes.set_ylim(floor, 2.0 * max(np.max(values), high * 1.5))
    _panel(axes, title, f"{100 * np.mean(inside):.0f} % inside the 95 % bounds · mean "
           f"{np.sum(values * dof) / np.sum(dof):.2f}, expected {expected:g}")


def _pose_panels(axes, seconds, pose):
    t = seconds[pose.valid]
    for k, (name, unit, factor) in enumerate((("Error in x", "m", 1.0), ("Error in y", "m", 1.0),
                                              ("Error in heading", "deg", 180.0 / np.pi))):
        _error_panel(axes[k], t, factor * pose.errors[:, k], factor * pose.sigmas[:, k],
                     name, unit)
    _quadratic_panel(axes[3], t, pose.nees, np.full(len(t), 3), "NEES (3 degrees of freedom)", 3.0)


def _nis_panel(axes, seconds, updates, used):
    dof = updates.nis_dof[used]
    _quadratic_panel(axes, seconds[used], updates.nis[used] / dof, dof,
                     "NIS per degree of freedom", 1.0)


def plot_consistency(run, result, path):
    """Errors with their bands, NEES and NIS over time. Returns False where there is nothing."""
    pose, updates = result.consistency, run.updates
    used = np.zeros(0, dtype=bool) if updates is None else updates.nis_dof > 0
    count = (4 if pose is not None else 0) + (1 if np.any(used) else 0)
    if count == 0:
        return False
    seconds = (run.trajectory.stamps - run.trajectory.stamps[0]) / NANOSECONDS
    with look.style():
        figure, grid = look.plt.subplots(count, 1, sharex=True, squeeze=False,
                                         figsize=(9.2, 0.9 + 1.85 * count))
        axes = list(grid[:, 0])
        if pose is not None:
            _pose_panels(axes, seconds, pose)
        if np.any(used):
            _nis_panel(axes[-1], seconds, updates, used)
        axes[-1].set_xlabel("time [s]")
        _legend(figure, pose is not None)
        figure.tight_layout(rect=(0.0, 0.36 / figure.get_figheight(), 1.0, 1.0))
        look.save(figure, path)
    return True


def _legend(figure, with_errors):
    line, patch = look.plt.Line2D, look.plt.Rectangle
    dot = {"linestyle": "none", "marker": ".", "markersize": 7}
    handles = [
        (line([], [], color=look.ESTIMATE, **dot), "step inside its bounds"),
        (line([], [], color=look.ERROR, **dot), "step outside"),
        (line([], [], color=look.TRUTH, linewidth=1.4), "running mean"),
        (patch((0, 0), 1, 1, color=look.LANDMARK, alpha=0.2, linewidth=0), "95 % bounds"),
    ]
    if with_errors:
        handles = [(line([], [], color=look.ESTIMATE, linewidth=1.4), "error"),
                   (patch((0, 0), 1, 1, color=look.BAND, alpha=0.2, linewidth=0),
                    "the filter's 95 % band")] + handles
    figure.legend([h for h, _ in handles], [text for _, text in handles], loc="lower center",
                  ncol=6, columnspacing=1.4, handlelength=1.5, bbox_to_anchor=(0.5, 0.004))
