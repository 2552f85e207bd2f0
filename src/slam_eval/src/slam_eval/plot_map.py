# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""trajectory.png and map.png."""
import numpy as np

from slam_eval import plot_style as look
from slam_eval import se2
from slam_eval.landmarks import match_by_id
from slam_eval.trajectory import NANOSECONDS


def _with_gaps(stamps, positions, max_gap):
    """Positions with a NaN where the stamps [ns] jump, so that no line is drawn across."""
    breaks = np.flatnonzero(np.diff(stamps) > int(max_gap * NANOSECONDS)) + 1
    return np.insert(positions, breaks, np.nan, axis=0)


def _draw_path(axes, stamps, positions, **options):
    """A path as a line; dotted where nothing was written for long: the way there is unknown."""
    pause = max(10.0 * float(np.median(np.diff(stamps))) / NANOSECONDS, 2.0) if len(
        stamps) > 1 else 2.0
    axes.plot(*_with_gaps(stamps, positions, pause).T, **options)
    ends = np.flatnonzero(np.diff(stamps) > int(pause * NANOSECONDS))
    if len(ends):
        look.draw_segments(axes, positions[ends], positions[ends + 1], linestyle=(0, (1, 2.2)),
                           color=options['color'], linewidth=0.9, zorder=options['zorder'])


def _truth_in_map(run, result):
    if run.truth is None or result.ate is None:
        return None
    # Of a long truth recording only the time of the run is of interest.
    stamps = run.trajectory.stamps
    during = (run.truth.stamps >= stamps[0]) & (run.truth.stamps <= stamps[-1])
    part = type(run.truth)(run.truth.stamps[during], run.truth.poses[during])
    poses = se2.transform_poses(se2.inverse(result.ate.T_truth_map), part.poses)
    return _with_gaps(part.stamps, poses[:, :2], 0.5)


def _odometry_in_map(run):
    if run.odometry is None:
        return None
    T = se2.compose(run.trajectory.poses[0], se2.inverse(run.odometry.poses[0]))
    return se2.transform_poses(T, run.odometry.poses)[:, :2]


def _bounds(*parts):
    points = np.vstack([p for p in parts if p is not None and len(p)])
    return points[np.all(np.isfinite(points), axis=1)]


def _extent(landmarks, scale=1.0):
    """Corners of the ellipses, so that they fit; a huge one may reach over the edge."""
    if landmarks is None or not len(landmarks):
        return ()
    reach = 2.45 * scale * np.sqrt(np.maximum(np.einsum('nii->ni', landmarks.covariances), 0.0))
    reach = np.minimum(reach, 0.3 * max(float(np.max(np.ptp(landmarks.positions, axis=0))), 1.0))
    return landmarks.positions - reach, landmarks.positions + reach


def _draw_map(axes, landmarks):
    look.draw_ellipses(axes, landmarks.positions, landmarks.covariances, label='95 % ellipse')
    axes.plot(*landmarks.positions.T, '.', color=look.LANDMARK, markersize=5, zorder=5,
              label='landmark')
    look.label_landmarks(axes, landmarks.ids, landmarks.positions)


def _draw_true_landmarks(axes, positions):
    axes.plot(*positions.T, linestyle='none', marker='+', color=look.TRUTH, markersize=7,
              markeredgewidth=0.9, zorder=6, label='true landmark')


def plot_trajectory(run, result, path, reference='ground truth'):
    """Estimate, truth, dead reckoning and landmarks, all in the map frame."""
    truth, odometry = _truth_in_map(run, result), _odometry_in_map(run)
    estimate = run.trajectory.poses[:, :2]
    landmarks = run.landmarks if run.landmarks is not None and len(run.landmarks) else None
    true_landmarks = None
    if result.ate is not None and run.true_landmarks is not None and len(run.true_landmarks):
        true_landmarks = se2.transform_points(se2.inverse(result.ate.T_truth_map),
                                              run.true_landmarks.positions)
    with look.style():
        figure, axes = look.plan_axes(_bounds(
            estimate, truth, odometry, true_landmarks, *_extent(landmarks)))
        if odometry is not None:
            _draw_path(axes, run.odometry.stamps, odometry, color=look.ODOMETRY, linewidth=1.1,
                       zorder=1, label='dead reckoning')
        if truth is not None:
            axes.plot(*truth.T, color=look.TRUTH, linewidth=2.6, alpha=0.35, zorder=2,
                      label=reference)
        _draw_path(axes, run.trajectory.stamps, estimate, color=look.ESTIMATE, linewidth=1.3,
                   zorder=3, label='estimate')
        if true_landmarks is not None:
            _draw_true_landmarks(axes, true_landmarks)
        if landmarks is not None:
            _draw_map(axes, landmarks)
        axes.plot(*estimate[0], 'o', color='white', markeredgecolor=look.ESTIMATE,
                  markeredgewidth=1.6, markersize=7, zorder=8, label='start')
        look.draw_pose(axes, run.trajectory.poses[-1], 'end')
        text = f'Trajectory · {run.title}'
        if result.ate is not None:
            text += f' · ATE {result.ate.rmse:.4f} m'
        axes.set_title(text)
        look.legend_below(figure, axes)
        look.save(figure, path)


def _magnification(landmarks, offsets, span):
    """How much larger than life errors and ellipses are drawn, so that they can be seen."""
    sizes = 2.45 * np.sqrt(np.maximum(np.linalg.eigvalsh(landmarks.covariances)[:, 1], 0.0))
    if len(offsets):
        sizes = np.append(sizes, np.linalg.norm(offsets, axis=1))
    typical = np.percentile(sizes, 90)
    steps = [k for k in (1, 2, 5, 10, 20, 50, 100) if k * typical <= 0.04 * span]
    return steps[-1] if steps and typical > 0.0 else 1


def plot_map(run, result, path):
    """The landmarks with their ellipses and errors, and the pose at the end."""
    landmarks = run.landmarks
    pose = run.trajectory.poses[-1] if landmarks.pose is None else landmarks.pose
    true = offsets = np.zeros((0, 2))
    starts = offsets
    if result.landmark_error is not None:
        T = se2.inverse(result.landmark_error.T_truth_map)
        _, starts, matched = match_by_id(landmarks, run.true_landmarks)
        offsets = se2.transform_points(T, matched) - starts
        true = se2.transform_points(T, run.true_landmarks.positions)
    with look.style():
        points = _bounds(landmarks.positions, true, pose[None, :2])
        span = float(np.max(np.ptp(points, axis=0)))
        scale = _magnification(landmarks, offsets, span) if len(landmarks) else 1
        figure, axes = look.plan_axes(_bounds(points, *_extent(landmarks, scale)))
        larger = f', drawn {scale} times larger' if scale > 1 else ''
        if len(true):
            _draw_true_landmarks(axes, true)
            look.draw_segments(axes, starts, starts + scale * offsets, color=look.ERROR,
                               linewidth=1.6, zorder=6.5, label='error' + larger)
        look.draw_ellipses(axes, landmarks.positions, landmarks.covariances, scale,
                           '95 % ellipse' + larger)
        axes.plot(*landmarks.positions.T, '.', color=look.LANDMARK, markersize=4, zorder=5,
                  label='landmark')
        look.label_landmarks(axes, landmarks.ids, landmarks.positions)
        look.draw_pose(axes, pose, 'pose at the end')
        text = f'Map · {run.title} · {len(landmarks)} landmarks'
        if result.landmark_error is not None:
            text += f' · RMSE {result.landmark_error.rmse:.4f} m'
        axes.set_title(text)
        look.legend_below(figure, axes, columns=3)
        look.save(figure, path)
