# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths of odometries beside the true one (the thesis's figure 6.6b)."""
import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.trajectory import at_stamps
from slam_eval.plot import plan
from slam_eval.plot import style as look

_COLOURS = (look.ESTIMATE, look.ODOMETRY, look.LANDMARK)


def plot_odometry(truth, tracks, path):
    """truth: poses (N x 3); tracks: poses by name, each moved to start where truth does."""
    truth = np.asarray(truth, dtype=float)
    with look.style():
        figure, axes = look.plt.subplots(figsize=(7.2, 6.0), constrained_layout=True)
        axes.plot(*truth[:, :2].T, color=look.TRUTH, linewidth=1.0, linestyle=(0, (4, 4)), zorder=4,
                  label="truth")
        for colour, (name, poses) in zip(_COLOURS, tracks.items()):
            poses = np.asarray(poses, dtype=float)
            moved = se2.transform_poses(se2.compose(truth[0], se2.inverse(poses[0])), poses)
            axes.plot(*moved[:, :2].T, color=colour, linewidth=1.8, label=name)
        axes.plot(*truth[0, :2], "o", color="white", markeredgecolor=look.TRUTH, zorder=5,
                  label="start")
        axes.set_aspect("equal")
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
        axes.legend(loc="best", fontsize=9)
        look.save(figure, path)


def plot_beside_wheels(run, result, path, reference="ground truth", world=None):
    """The run's odometry beside that of the wheels it did not use; returns whether there are both.

    Both begin at the first pose of the estimate, onto which truth is moved.
    """
    if run.odometry is None or run.wheels is None:
        return False
    wheels = at_stamps(run.wheels, run.trajectory.stamps)
    tracks = {"visual odometry": (run.odometry, look.ESTIMATE, result.odometry_ate),
              "wheel odometry": (wheels, look.ODOMETRY, result.wheels_ate)}
    tracks = {name: (plan.from_start(run, odometry), *rest)
              for name, (odometry, *rest) in tracks.items() if len(odometry)}
    truth, world = plan.truth_in_map(run, result), plan.world_in_map(world, result)
    with look.style():
        figure, axes = look.plan_axes(plan.bounds(*(track for track, *_ in tracks.values()), truth,
                                                  world=world))
        plan.draw_world(axes, world)
        for name, (track, colour, _) in reversed(tracks.items()):
            axes.plot(*track.T, color=colour, linewidth=1.6, zorder=2, label=name)
        plan.draw_truth(axes, truth, reference)
        axes.set_title(f"Odometry alone · {run.title}")
        errors = [f"{name.split()[0]} {error.rmse:.3f} m"
                  for name, (_, _, error) in tracks.items() if error is not None]
        look.remark(axes, "ATE " + " · ".join(errors) if errors else "")
        look.legend_below(figure, axes, columns=5)
        look.save(figure, path)
    return True
