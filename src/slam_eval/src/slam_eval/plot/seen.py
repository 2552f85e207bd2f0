# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""seen.png: over time, how many features an image has, and what became of them; of products with
landmarks the same of observations."""
import numpy as np

from slam_eval.io.trajectory import NANOSECONDS
from slam_eval.plot import style as look

MOST_POINTS = 1000  # of a line: more of them are averaged, so that the line can be read
COLOURS = (look.MUTED, look.ODOMETRY, look.LANDMARK, look.ERROR)


def series_of(run):
    """(stamps [ns], counts by label) of what was seen; None where the run has nothing of it."""
    if run.views is not None and len(run.views):
        counts = run.views.counts
        return run.views.stamps, {
            "features located": counts["features"],
            "searched for": counts["expected"],
            "matched": counts["matched"],
            "rejected": counts["rejected"]}
    if run.updates is None:
        return None
    counts = run.updates.counts
    seen = counts["used"] + counts["gated"] + counts["added"] + counts["unknown"]
    if not np.any(seen):
        return None
    return run.updates.stamps, {"observed": seen, "new to the map": counts["added"],
                                "used": counts["used"], "gated": counts["gated"]}


def averaged(seconds, values):
    """The series as means of so many neighbours that at most MOST_POINTS are left."""
    width = -(-len(values) // MOST_POINTS)
    starts = np.arange(0, len(values), width)
    sizes = np.diff(np.append(starts, len(values)))
    return (np.add.reduceat(seconds, starts) / sizes,
            np.add.reduceat(values.astype(float), starts) / sizes)


def plot_seen(run, _result, path):
    """What was seen over time. Returns False where there is nothing to show."""
    series = series_of(run)
    if series is None:
        return False
    stamps, counts = series
    seconds = (stamps - run.trajectory.stamps[0]) / NANOSECONDS
    with look.style():
        figure, axes = look.plt.subplots(figsize=(9.2, 3.6))
        for (label, values), colour in zip(counts.items(), COLOURS):
            axes.plot(*look.with_gaps(*averaged(seconds, values)), color=colour, linewidth=1.1,
                      label=f"{label} ({np.sum(values)} in all)")
        axes.set_ylim(bottom=0.0)
        axes.margins(x=0.01)
        axes.set_xlabel("time [s]")
        axes.set_ylabel("count")
        axes.set_title(f"What was seen · {run.title}")
        look.plain(axes)
        look.legend_below(figure, axes)
        figure.tight_layout(rect=(0.0, 0.08, 1.0, 1.0))
        look.save(figure, path)
    return True
