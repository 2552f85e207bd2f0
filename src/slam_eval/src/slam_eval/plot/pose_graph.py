# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a graph of poses that was solved pose by pose."""
import numpy as np

from slam_eval.plot import style as look


def _draw_loops(axes, positions, loops, colour, label):
    if len(loops):
        look.draw_segments(axes, positions[loops[:, 0]], positions[loops[:, 1]], color=colour,
                           linewidth=0.5, alpha=0.7, zorder=2, label=f"{len(loops)} {label}")


def _draw_graph(axes, report):
    positions = np.array(report["trajectory"])[:, :2]
    loops = np.array(report["loop_edges"], dtype=int).reshape(-1, 3)
    if report["truth"]:
        axes.plot(*np.array(report["truth"]).T, color=look.TRUTH, linewidth=1.8, alpha=0.3,
                  zorder=1, label="truth")
    _draw_loops(axes, positions, loops[loops[:, 2] == 0], look.ODOMETRY, "loops")
    _draw_loops(axes, positions, loops[loops[:, 2] == 1], look.ERROR, "false loops")
    axes.plot(*positions.T, color=look.ESTIMATE, linewidth=0.8, zorder=3,
              label=f"{len(positions)} poses")
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=3)
    axes.set_title(f"Graph · {report['name'].replace('_', ' ')}")
    look.plain(axes)


def _draw_times(axes, report):
    times = np.array(report["steps_ms"])
    axes.plot(np.arange(1, len(times) + 1), times, ".", color=look.ESTIMATE, markersize=2.5,
              alpha=0.6, markeredgewidth=0)
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(look.plt.FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_xlabel("step")
    axes.set_ylabel("CPU time [ms]")
    axes.set_title("Time of a step")
    look.remark(axes, f"mean {report['mean_ms']:.2f} ms, worst {report['worst_ms']:.1f} ms")
    look.plain(axes)


def plot_graph(report, path):
    """The solved poses with their loops, the truth behind them, and the time of each step."""
    with look.style():
        figure, (left, right) = look.plt.subplots(1, 2, figsize=(11.0, 5.2),
                                                  constrained_layout=True)
        _draw_graph(left, report)
        _draw_times(right, report)
        look.save(figure, path)
