# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plans are made of: truth and dead reckoning in the map frame, paths, landmarks."""
import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.grid_map import FREE, OCCUPIED
from slam_eval.io.trajectory import NANOSECONDS
from slam_eval.metrics.chi_square import chi_square_quantile
from slam_eval.plot import style as look

_OCCUPIED_GREY, _FREE_GREY, _UNKNOWN_GREY = 0, 254, 205  # as map_server writes them
_MOST_CELLS = 1000  # that a picture shows a side
_SIGMAS_95 = np.sqrt(chi_square_quantile(0.95, 2))  # half axis of a 95 % ellipse in sigmas


def _with_gaps(stamps, positions, max_gap):
    """Positions with a NaN where the stamps [ns] jump, so that no line is drawn across."""
    breaks = np.flatnonzero(np.diff(stamps) > int(max_gap * NANOSECONDS)) + 1
    return np.insert(positions, breaks, np.nan, axis=0)


def draw_path(axes, stamps, positions, **options):
    """A path as a line; dotted where nothing was written for long: the way there is unknown."""
    pause = max(10.0 * float(np.median(np.diff(stamps))) / NANOSECONDS, 2.0) if len(
        stamps) > 1 else 2.0
    axes.plot(*_with_gaps(stamps, positions, pause).T, **options)
    ends = np.flatnonzero(np.diff(stamps) > int(pause * NANOSECONDS))
    if len(ends):
        look.draw_segments(axes, positions[ends], positions[ends + 1], linestyle=(0, (1, 2.2)),
                           color=options["color"], linewidth=0.9, zorder=options["zorder"])


def draw_estimate(axes, run):
    """The estimated path with its start and the pose at its end."""
    estimate = run.trajectory.poses[:, :2]
    draw_path(axes, run.trajectory.stamps, estimate, color=look.ESTIMATE, linewidth=2.0, zorder=3,
              label="SLAM")
    # A ring, so that the end can be seen in it where the robot came back.
    axes.plot(*estimate[0], linestyle="none", marker="o", fillstyle="none",
              markeredgecolor=look.ESTIMATE, markeredgewidth=1.8, markersize=12, zorder=7.5,
              label="start", path_effects=look.halo(3.8))
    look.draw_pose(axes, run.trajectory.poses[-1], "end")


def draw_truth(axes, truth, name):
    """The true path: thin and dashed, over the estimate that it would hide behind."""
    if truth is not None:
        # Short dashes far apart: those of a second lap fill the gaps of the first.
        axes.plot(*truth.T, color="black", linewidth=0.9, linestyle=(0, (4, 10)), zorder=3.5,
                  label=name)


def truth_in_map(run, result):
    """The true path while the run lasted (N x 2, NaN at gaps), moved onto the estimate; or None."""
    if run.truth is None or result.ate is None:
        return None
    # Of a long truth recording only the time of the run is of interest.
    stamps = run.trajectory.stamps
    during = (run.truth.stamps >= stamps[0]) & (run.truth.stamps <= stamps[-1])
    part = type(run.truth)(run.truth.stamps[during], run.truth.poses[during])
    poses = se2.transform_poses(se2.inverse(result.ate.T_truth_map), part.poses)
    # Fixes without headings come at 1 Hz or so.
    return _with_gaps(part.stamps, poses[:, :2], 0.5 if run.truth.has_heading else 2.5)


def true_landmarks_in_map(run, result):
    """True landmarks (N x 2), moved by the alignment of the path, else by their own; or None."""
    alignment = result.ate or result.landmark_error
    if alignment is None or run.true_landmarks is None or not len(run.true_landmarks):
        return None
    return se2.transform_points(se2.inverse(alignment.T_truth_map), run.true_landmarks.positions)


def world_in_map(world, result):
    """A WorldPlan moved onto the estimate, as the truth is; or None."""
    alignment = result.ate or result.landmark_error
    if world is None or alignment is None:
        return None
    T = se2.inverse(alignment.T_truth_map)
    return type(world)([se2.transform_points(T, wall) for wall in world.walls],
                       [se2.transform_points(T, outline) for outline in world.furniture])


def draw_world(axes, world, filled=True):
    """Walls and furniture behind everything; over a grid as thin lines, for comparison."""
    for outline in world.furniture if world else ():
        if filled:
            axes.fill(*outline.T, facecolor="#eceef1", edgecolor="#d5d9de", linewidth=0.8,
                      zorder=0.5)
        else:
            axes.fill(*outline.T, fill=False, edgecolor=look.LANDMARK, linewidth=0.6, zorder=0.6)
    for wall in world.walls if world else ():
        axes.plot(*wall.T, zorder=0.6, **({"color": "#b4bac2", "linewidth": 2.2} if filled else
                                          {"color": look.LANDMARK, "linewidth": 0.6}))


def grid_corners(grid):
    """Two opposite corners of a GridMap (2 x 2), or None."""
    if grid is None:
        return None
    size = grid.resolution * np.array(grid.cells.shape[::-1])
    return np.array([grid.origin, grid.origin + size])


def draw_grid(axes, grid):
    """A GridMap under everything, in the greys of map_server's images."""
    if grid is None:
        return
    shown = grid.coarser(_MOST_CELLS)
    (left, bottom), (right, top) = grid_corners(shown)
    greys = np.full(shown.cells.shape, _UNKNOWN_GREY, np.uint8)
    greys[shown.cells == FREE] = _FREE_GREY
    greys[shown.cells == OCCUPIED] = _OCCUPIED_GREY
    axes.imshow(greys, origin="lower", extent=(left, right, bottom, top), zorder=0.4,
                interpolation="nearest", aspect="equal", cmap="gray", vmin=0, vmax=255)
    axes.set_facecolor(_colour(_UNKNOWN_GREY))
    axes.grid(False)
    for grey, label in ((_OCCUPIED_GREY, "occupied"), (_FREE_GREY, "free"),
                        (_UNKNOWN_GREY, "unknown")):
        axes.plot([], [], linestyle="none", marker="s", color=_colour(grey),
                  markeredgecolor=look.MUTED, markeredgewidth=0.5, markersize=7, label=label)


def _colour(grey):
    return (grey / 255.0,) * 3


def draw_points(axes, points):
    """The points of a point map as dots."""
    if points is not None and len(points):
        axes.plot(*points.T, "," if len(points) > 20000 else ".", color="#7d4fa8",
                  markersize=1.2 if len(points) > 2000 else 2.4, zorder=1.5,
                  label="point of the laser")


def odometry_in_map(run):
    """Dead reckoning (N x 2) from the first pose of the estimate on, or None."""
    return from_start(run, run.odometry)


def from_start(run, odometry):
    """Positions (N x 2) of an odometry that is moved onto the estimate by its first pose, or None.

    Its stamps are some of the estimate's.
    """
    if odometry is None or not len(odometry):
        return None
    first = np.searchsorted(run.trajectory.stamps, odometry.stamps[0])
    T = se2.compose(run.trajectory.poses[first], se2.inverse(odometry.poses[0]))
    return se2.transform_poses(T, odometry.poses)[:, :2]


def bounds(*parts, world=None):
    """The finite points of all parts that are there, the walls' included."""
    parts = [*parts, *(world.walls if world else ())]
    points = np.vstack([p for p in parts if p is not None and len(p)])
    return points[np.all(np.isfinite(points), axis=1)]


def extent(landmarks, scale=1.0):
    """Corners of the ellipses, so that they fit; a huge one may reach over the edge."""
    if landmarks is None or not len(landmarks.ids):
        return ()
    reach = _SIGMAS_95 * scale * np.sqrt(
        np.maximum(np.einsum("nii->ni", landmarks.covariances), 0.0))
    reach = np.minimum(reach, 0.3 * max(float(np.max(np.ptp(landmarks.positions, axis=0))), 1.0))
    return landmarks.positions - reach, landmarks.positions + reach


def magnification(landmarks, errors, span, part=0.04):
    """How much larger than life ellipses and errors [m] are drawn, so that they can be seen:
    most of them stay under a part of the picture's span [m]."""
    sizes = _SIGMAS_95 * np.sqrt(
        np.maximum(np.linalg.eigvalsh(landmarks.covariances)[:, 1], 0.0))
    typical = np.percentile(np.append(sizes, errors), 90)
    steps = [k for k in (1, 2, 5, 10, 20, 50, 100) if k * typical <= part * span]
    return steps[-1] if steps and typical > 0.0 else 1


def larger(scale):
    """What the legend adds for a magnification."""
    return f", drawn {scale} times larger" if scale > 1 else ""


def draw_lines(axes, landmarks):
    """Line landmarks, as far as they were seen."""
    for i, ends in enumerate(landmarks.lines if landmarks is not None else ()):
        axes.plot(*ends.T, "-", color=look.LANDMARK, linewidth=1.6, zorder=4,
                  label="line landmark" if i == 0 else None)


def draw_landmarks(axes, landmarks, scale, labels=None):
    """Landmarks with their 95 % ellipses and ids; labels, {id: text}, stand behind the ids."""
    look.draw_ellipses(axes, landmarks.positions, landmarks.covariances, scale,
                       "95 % ellipse" + larger(scale))
    axes.plot(*landmarks.positions.T, ".", color=look.LANDMARK, markersize=4, zorder=5,
              label="landmark")
    names = [f"{identity} {(labels or {}).get(identity, '')}".rstrip().replace("$", r"\$")
             for identity in landmarks.ids]
    look.label_landmarks(axes, names, landmarks.positions)


def draw_true_landmarks(axes, positions):
    """True landmarks as crosses."""
    if positions is not None and len(positions):
        axes.plot(*positions.T, linestyle="none", marker="+", color=look.TRUTH, markersize=8,
                  markeredgewidth=0.9, zorder=6, label="true landmark")
