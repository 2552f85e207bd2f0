# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""relations.png: how the errors against the reference relations are distributed."""
import numpy as np

from slam_eval.plot import style as look


def _histogram(axes, values, unit, name):
    """Counts up to the 99th percentile; what lies beyond is told in words."""
    limit = max(float(np.percentile(values, 99)), 1e-6)
    axes.hist(values[values <= limit], bins=60, range=(0.0, limit), color=look.BAND, alpha=0.75)
    lines = ((np.mean(values), "-", "mean"), (np.median(values), "--", "median"))
    for value, style, label in lines:
        axes.axvline(value, color=look.ERROR, linewidth=1.3, linestyle=style,
                     label=f"{label} {value:.3f} {unit}")
    axes.set_xlim(0.0, limit)
    axes.set_xlabel(f"{name} error [{unit}]")
    look.remark(axes, f"{np.count_nonzero(values > limit)} above, "
                      f"largest {np.max(values):.2f} {unit}")
    axes.legend(loc="upper right")


def plot_relations(title, errors, path):
    """Draw the histograms of RelationErrors."""
    with look.style():
        figure, (left, right) = look.plt.subplots(1, 2, figsize=(8.6, 3.6))
        _histogram(left, errors.translation, "m", "translation")
        _histogram(right, np.degrees(errors.rotation), "deg", "rotation")
        left.set_ylabel("relations")
        figure.suptitle(f"Relations · {title}", x=0.02, ha="left", fontsize=11.5,
                        fontweight="bold", color="#22262b")
        figure.tight_layout()
        look.save(figure, path)
