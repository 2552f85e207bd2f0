# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours, axes and file writing shared by all pictures."""
import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402
from matplotlib.patheffects import withStroke  # noqa: E402
import numpy as np  # noqa: E402

from slam_eval.io.atomic_file import replaced  # noqa: E402
from slam_eval.metrics.chi_square import chi_square_quantile  # noqa: E402

ESTIMATE = "#1f5fa8"
TRUTH = "#2b2b2b"
ODOMETRY = "#e39a4b"
LANDMARK = "#0f8a6d"
ERROR = "#c8402f"
BAND = "#1f5fa8"
MUTED = "#7a7f87"

_STYLE = {
    "font.family": "DejaVu Sans", "font.size": 9.5, "axes.edgecolor": "#b9bec5",
    "axes.linewidth": 0.8, "axes.grid": True, "axes.axisbelow": True, "grid.color": "#e6e8eb",
    "grid.linewidth": 0.7, "axes.labelcolor": "#4a4f57", "xtick.color": "#4a4f57",
    "ytick.color": "#4a4f57", "axes.titlesize": 11.5, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.titlecolor": "#22262b", "legend.frameon": False,
    "legend.fontsize": 9, "figure.facecolor": "white", "savefig.facecolor": "white",
    "xtick.major.size": 0, "ytick.major.size": 0, "lines.solid_capstyle": "round",
}


def style():
    """Context in which a picture is drawn."""
    return plt.rc_context(_STYLE)


def save(figure, path):
    """Write a picture completely or not at all."""
    try:
        with replaced(path) as temporary:
            figure.savefig(temporary, format="png", dpi=150)
    finally:
        plt.close(figure)


def plain(axes):
    """Leaves out the lines above and to the right of a picture."""
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def remark(axes, text):
    """What stands to the right of a title."""
    axes.set_title(text, loc="right", fontsize=9, fontweight="normal", color=MUTED)


def with_gaps(t, values):
    """The series with a NaN where its steps are far apart, so that no line is drawn across."""
    steps = np.diff(t)
    wide = np.flatnonzero(steps > max(10.0 * np.median(steps), 3.0)) + 1 if len(steps) else []
    return np.insert(t, wide, np.nan), np.insert(values, wide, np.nan)


def plan_axes(points, width=8.6):
    """Figure and axes with equal scales [m] that fit the points, room for the legend below."""
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    margin = 0.06 * max(float(np.max(high - low)), 0.1)
    low, high = low - margin, high + margin
    spread = high - low
    # Neither a ribbon nor a tower: the shorter side is widened to at least half of the longer.
    short = np.maximum(spread, 0.5 * np.max(spread))
    low, high = low - 0.5 * (short - spread), high + 0.5 * (short - spread)
    above, below = 0.5, 1.15
    inner = np.array([width - 1.1, (width - 1.1) * short[1] / short[0]])
    inner *= min(1.0, 9.0 / inner[1])
    size = (width, inner[1] + above + below)
    figure = plt.figure(figsize=size)
    left = 0.5 * (width - inner[0]) + 0.25
    axes = figure.add_axes([left / width, below / size[1], inner[0] / width, inner[1] / size[1]])
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    plain(axes)
    return figure, axes


def legend_below(figure, axes, columns=4):
    """The legend under the picture, where it can hide nothing."""
    handles, labels = axes.get_legend_handles_labels()
    return figure.legend(handles, labels, loc="lower center", ncol=min(columns, len(labels)),
                         bbox_to_anchor=(0.5, 0.005), columnspacing=1.8, handlelength=1.9)


def draw_ellipses(axes, positions, covariances, scale=1.0, label=None):
    """95 % ellipses of 2-D positions."""
    angle = np.linspace(0.0, 2.0 * np.pi, 49)
    circle = np.sqrt(chi_square_quantile(0.95, 2)) * scale * np.array(
        [np.cos(angle), np.sin(angle)])
    outlines = []
    for position, P in zip(positions, covariances):
        values, vectors = np.linalg.eigh(P)
        outlines.append((vectors * np.sqrt(np.maximum(values, 0.0)) @ circle).T + position)
    axes.add_collection(PolyCollection(outlines, facecolor=LANDMARK + "33", edgecolor=LANDMARK,
                                       linewidth=0.9, zorder=4, label=label))


def draw_segments(axes, starts, ends, **options):
    """Short lines from each start to each end."""
    axes.add_collection(LineCollection(np.stack([starts, ends], axis=1), **options))


def halo(width):
    """A white border, so that what is drawn can be seen over anything."""
    return [withStroke(linewidth=width, foreground="white")]


def _label_side(positions, i, near):
    """Direction of a label: up and right, or away from a landmark that is near."""
    others = np.delete(positions, i, axis=0)
    if not len(others):
        return 1, 1
    away = positions[i] - others[np.argmin(np.linalg.norm(others - positions[i], axis=1))]
    if np.linalg.norm(away) > near:
        return 1, 1
    return (1 if away[0] >= 0.0 else -1), (1 if away[1] >= 0.0 else -1)


def _has_room(axes, position, text):
    """Whether a text on the right of a position ends within the picture, roughly."""
    least, most = axes.get_xlim()
    return len(text) <= 3 or position[0] + 0.011 * len(text) * (most - least) <= most


def label_landmarks(axes, ids, positions, most=120):
    """Ids beside the landmarks, unless there are so many that they would only cover the picture."""
    if len(ids) > most:
        return
    size = 7.5 if len(ids) <= 40 else 6.5
    near = 0.04 * float(np.ptp(axes.get_xlim()))
    for i, (identity, position) in enumerate(zip(ids, positions)):
        right, up = _label_side(positions, i, near)
        right = right if _has_room(axes, position, str(identity)) else -1
        axes.annotate(str(identity), position, xytext=(4.5 * right, 4.0 * up),
                      textcoords="offset points", fontsize=size, color="#0a5f4b", zorder=7,
                      ha="left" if right > 0 else "right", va="bottom" if up > 0 else "top",
                      path_effects=halo(2.0))


def draw_pose(axes, pose, label=None):
    """A pose as an arrow head that points along its heading."""
    axes.plot(pose[0], pose[1], linestyle="none", marker=(3, 0, np.degrees(pose[2]) - 90.0),
              markersize=10, color=ESTIMATE, markeredgecolor="white", markeredgewidth=1.0,
              zorder=8, label=label)
