# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the benchmarks."""
import numpy as np

from slam_eval.geometry import se2
from slam_eval.plot import plan
from slam_eval.plot import style as look

_COLOURS = (look.ESTIMATE, look.ODOMETRY, look.LANDMARK, look.ERROR, look.TRUTH)
_LINES = tuple((colour, dashes) for dashes in ("-", (0, (4, 2))) for colour in _COLOURS)


def _log_y(axes):
    """A logarithmic axis y whose ticks are written out."""
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(look.plt.FuncFormatter(lambda value, _: f"{value:g}"))


def _log_log(axes, x_values, x_label, y_label):
    """Logarithmic axes whose x ticks are the sizes that were measured."""
    axes.set_xscale("log")
    _log_y(axes)
    axes.set_xticks(x_values, [str(x) for x in x_values])
    axes.minorticks_off()
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    look.plain(axes)


def _name_line(axes, x, y, text, colour):
    """The name of a line at its end."""
    axes.annotate(text, (x, y), xytext=(8, 0), textcoords="offset points", color=colour,
                  va="center", fontsize=9)


def plot_average_nees(results, bounds, title, path):
    """NEES averaged over the seeds against the step, a line for each name, with its bounds."""
    with look.style():
        figure, axes = look.plt.subplots(figsize=(9.2, 4.4), constrained_layout=True)
        axes.axhspan(*bounds, color=look.BAND, alpha=0.18, linewidth=0)
        axes.axhline(3.0, color=look.MUTED, linewidth=0.8, linestyle=(0, (4, 3)))
        for (colour, dashes), (name, result) in zip(_LINES, results.items()):
            values = result["average_nees"]
            axes.plot(np.arange(1, len(values) + 1), values, color=colour, linewidth=1.1,
                      linestyle=dashes, label=name.replace("_", " "))
        _log_y(axes)
        axes.set_xlabel("step")
        axes.set_ylabel("NEES of the pose")
        axes.margins(x=0.02)
        axes.legend(loc="upper left", frameon=False, fontsize=9)
        axes.set_title(title)
        look.remark(axes, "band: 95 % bounds")
        look.plain(axes)
        look.save(figure, path)


def _plot_lines(lines, title, y_label, path):
    """Named lines of (sizes, values) in logarithmic axes."""
    with look.style():
        figure, axes = look.plt.subplots(figsize=(7.6, 4.8), constrained_layout=True)
        for (colour, dashes), (name, (x, y)) in zip(_LINES, lines.items()):
            axes.plot(x, y, color=colour, marker="o", markersize=5, linewidth=1.5, linestyle=dashes)
            _name_line(axes, x[-1], y[-1], name, colour)
        sizes = sorted({value for x, _ in lines.values() for value in x})
        _log_log(axes, sizes, "landmarks", y_label)
        axes.margins(x=0.22)
        axes.set_title(title)
        look.save(figure, path)


def plot_cpu(sizes, product, path):
    """CPU time of ours and kf-slam against the number of landmarks."""
    x = [size.landmarks for size in sizes]
    lines = {product: (x, [size.ours.usage.cpu_s for size in sizes])}
    if all(size.theirs is not None for size in sizes):
        lines["kf-slam"] = (x, [size.theirs.usage.cpu_s for size in sizes])
    _plot_lines(lines, "CPU time of the whole run", "CPU time [s]", path)


def plot_updates(sizes, path):
    """Times against the number of landmarks, a line for each thing that was measured."""
    lines = {}
    for task in dict.fromkeys(task for size in sizes for task in size.times):
        measured = [size for size in sizes if task in size.times]
        lines[task] = ([size.landmarks for size in measured],
                       [size.times[task] for size in measured])
    _plot_lines(lines, "CPU time of one update", "CPU time [ms]", path)


def _draw_robot(axes, robot):
    run, result = robot.run, robot.result
    estimate = run.trajectory.poses
    if result.ate is not None:
        estimate = se2.transform_poses(result.ate.T_truth_map, estimate)
        start, end = run.trajectory.stamps[[0, -1]]
        during = (run.truth.stamps >= start) & (run.truth.stamps <= end)
        axes.plot(*run.truth.poses[during, :2].T, color=look.TRUTH, linewidth=1.8, alpha=0.35)
    axes.plot(*estimate[:, :2].T, color=look.ESTIMATE, linewidth=0.7)
    if run.true_landmarks is not None:
        axes.plot(*run.true_landmarks.positions.T, "+", color=look.LANDMARK, markersize=6)
    axes.set_aspect("equal", adjustable="datalim")
    title = f"robot {robot.name}"
    axes.set_title(title if result.ate is None else f"{title} · ATE {result.ate.rmse:.2f} m",
                   fontsize=10)
    look.plain(axes)


def plot_trajectories(robots, path):
    """Estimate, aligned to the truth, truth and true landmarks of each robot side by side."""
    with look.style():
        # One panel more than robots: it holds the legend.
        figure, grid = look.plt.subplots(2, len(robots) // 2 + 1, squeeze=False,
                                         figsize=(10.0, 7.0), constrained_layout=True)
        for axes, robot in zip(grid.flat, robots):
            _draw_robot(axes, robot)
        for axes in grid.flat[len(robots):]:
            axes.axis("off")
        line = look.plt.Line2D
        handles = [line([], [], color=look.ESTIMATE, linewidth=1.2),
                   line([], [], color=look.TRUTH, linewidth=2.4, alpha=0.35),
                   line([], [], color=look.LANDMARK, marker="+", linestyle="none")]
        grid.flat[-1].legend(handles, ["estimate", "ground truth", "true landmark"], loc="center")
        look.save(figure, path)


def plot_seeds(errors, goal, path):
    """Trajectory errors [m] by name, a dot a seed, with the goal that the first of them has."""
    with look.style():
        figure, axes = look.plt.subplots(figsize=(9.2, 4.2), constrained_layout=True)
        for colour, (name, values) in zip((look.ESTIMATE, look.ODOMETRY), errors.items()):
            seeds = np.arange(1, len(values) + 1)
            axes.plot(seeds, values, "o", color=colour, markersize=6)
            _name_line(axes, seeds[-1], values[-1], name, colour)
        if goal is not None:
            axes.axhline(goal, color=look.MUTED, linewidth=0.9, linestyle=(0, (4, 3)))
            axes.annotate(f"goal {goal:g} m", (1, goal), xytext=(0, 3), fontsize=8.5,
                          textcoords="offset points", color=look.MUTED)
        _log_y(axes)
        axes.set_xticks(seeds)
        axes.margins(x=0.08)
        axes.set_xlabel("seed")
        axes.set_ylabel("ATE [m]")
        axes.set_title("Trajectory error by seed")
        look.plain(axes)
        look.save(figure, path)


def plot_maps(runs, path):
    """Grids and paths of some runs (by their titles) of one log side by side, each in its own
    frame."""
    columns = min(len(runs), 2)
    rows = -(-len(runs) // columns)
    with look.style():
        figure, grid = look.plt.subplots(rows, columns, squeeze=False, constrained_layout=True,
                                         figsize=(5.2 * columns, 4.6 * rows))
        for axes in grid.flat[len(runs):]:
            axes.axis("off")
        for axes, (title, run) in zip(grid.flat, runs.items()):
            estimate = run.final or run.trajectory
            plan.draw_grid(axes, run.grid and run.grid.known_part())
            plan.draw_path(axes, estimate.stamps, estimate.poses[:, :2], color=look.ESTIMATE,
                           linewidth=0.7, zorder=3)
            axes.set_aspect("equal", adjustable="datalim")
            axes.set_title(title, fontsize=10)
            look.plain(axes)
        look.save(figure, path)
