# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What people would rather look at: messages over time, odometry's path, scans of a turn."""
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402, after the choice of what draws
import numpy as np  # noqa: E402

from slam_doctor.errors import InputError
from slam_doctor.scans.match import moved


def draw(case, path):
    """Writes the picture. Raises InputError."""
    figure = plt.figure(figsize=(13, 9), constrained_layout=True)
    grid = figure.add_gridspec(2, 2, height_ratios=[2, 3])
    draw_rates(figure.add_subplot(grid[0, :]), case)
    draw_path(figure.add_subplot(grid[1, 0]), case)
    draw_scans(figure.add_subplot(grid[1, 1]), case)
    figure.suptitle(f"{case.recording.name}: {case.recording.duration():.0f} s")
    try:
        figure.savefig(pathlib.Path(path), dpi=90)
    except (OSError, ValueError) as fault:
        raise InputError(f"cannot write {path}: "
                         f"{getattr(fault, 'strerror', None) or fault}") from None
    finally:
        plt.close(figure)


def draw_rates(axis, case):
    """Messages per second of each sensor, as shares of its usual rate; gaps are white."""
    sensors = list(case.sensors.values())
    duration = max(case.recording.duration(), 1e-3)
    for row, sensor in enumerate(sensors):
        timeline = sensor.topic.stream.timeline
        rates = np.array(timeline.counts) / timeline.width
        usual = np.median(rates[rates > 0]) if (rates > 0).any() else 1.0
        edges = timeline.width * np.arange(len(rates) + 1)
        colours = np.where(rates == 0, 0.0, np.clip(rates / usual, 0.15, 1.0))[None, :]
        axis.pcolormesh(edges, [row - 0.3, row + 0.3], colours, cmap="Blues", vmin=0, vmax=1.3)
        draw_gap(axis, row, sensor.topic.stream)
    axis.set_yticks(range(len(sensors)), [f"{s.topic.name}\n{1 / s.topic.stream.interval():.3g} Hz"
                                          for s in sensors])
    axis.set(xlim=(0, duration), ylim=(-0.5, len(sensors) - 0.3),
             xlabel="time since the first message [s]",
             title="messages: the darker, the more; red: each topic's longest gap")


def draw_gap(axis, row, stream):
    """The longest gap over a topic's row, where it is longer than others."""
    gap, begin, end = stream.longest_gap  # by stamps, which begin about when arrivals do
    if gap > 3 * stream.interval():
        axis.plot([begin, end], [row + 0.38] * 2, color="tab:red", linewidth=3)
        axis.text((begin + end) / 2, row + 0.41, f"{gap:.2g} s", color="tab:red", ha="center")


def draw_path(axis, case):
    """Odometry's path, coloured by time."""
    axis.set(title="odometry: path from blue to yellow", xlabel="x [m]", ylabel="y [m]")
    if case.path is None:
        axis.text(0.5, 0.5, "no odometry", ha="center", transform=axis.transAxes)
        return
    every = max(1, len(case.path) // 5000)
    x, y, t = (values[::every] for values in (case.path.x, case.path.y, case.path.stamps))
    axis.scatter(x, y, c=t, s=4, cmap="viridis")
    axis.plot(x[0], y[0], "o", color="tab:red", label="begin")
    axis.set_aspect("equal", adjustable="datalim")
    axis.legend(loc="upper right")


def draw_scans(axis, case):
    """Two scans of a turn, the second moved by what odometry tells: they should coincide."""
    axis.set(title="two scans of a turn, placed by odometry: walls should coincide", xlabel="x [m]",
             ylabel="y [m]")
    if not case.turns:
        axis.text(0.5, 0.5, "no turn that could be compared", ha="center", transform=axis.transAxes)
        return
    pair = case.turns.example
    axis.plot(*pair.first.T, ".", markersize=3, label="first scan")
    axis.plot(*moved(pair.odometry, pair.second).T, ".", markersize=3,
              label=f"second, turned by {pair.odometry[2]:+.2f} rad")
    axis.plot(0, 0, "^", color="black", label="robot")
    axis.set_aspect("equal", adjustable="datalim")
    axis.legend(loc="upper right")
