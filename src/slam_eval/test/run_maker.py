# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the folder of a simulated run whose errors are drawn from the covariance it claims."""
import pathlib
import sys

import numpy as np

# The tests run from the source tree too, without a catkin environment.
PACKAGE = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PACKAGE / "src"))

from slam_eval.geometry import se2  # noqa: E402

T_WORLD_MAP = np.array([3.0, -2.0, 0.7])
STEP = 0.2


def ring(count=1500, laps=3.0, radius=4.0):
    """True poses on a wavy ring, starting at the origin with heading 0."""
    phase = np.linspace(0.0, 2.0 * np.pi * laps, count)
    r = radius * (1.0 + 0.15 * np.sin(3.0 * phase))
    xy = np.column_stack([1.3 * r * np.sin(phase), radius - r * np.cos(phase)])
    heading = np.unwrap(np.arctan2(*np.gradient(xy, axis=0).T[::-1]))
    poses = np.column_stack([xy, se2.wrap_angle(heading)])
    return se2.transform_poses(se2.inverse(poses[0]), poses)


def tum_lines(stamps, poses):
    """Lines of a trajectory file."""
    half = 0.5 * poses[:, 2]
    return "".join("%.9f %.9f %.9f 0.000000000 0.000000000 0.000000000 %.9f %.9f\n"
                   % (t, x, y, s, c)
                   for t, (x, y, _), s, c in zip(stamps, poses, np.sin(half), np.cos(half)))


def landmark_lines(ids, positions, covariances=None, pose=None):
    """Text of a landmark map."""
    text = "version: 1\nframe: map\nunits: {position: m, angle: rad}\n"
    if pose is not None:
        text += 'stamp: "1000.000000000"\npose: {x: %.9f, y: %.9f, theta: %.9f, ' % tuple(pose)
        text += "covariance: [0, 0, 0, 0, 0, 0, 0, 0, 0]}\n"
    text += "landmarks:\n"
    for i, (identity, (x, y)) in enumerate(zip(ids, positions)):
        text += "  - {id: %d, x: %.9f, y: %.9f" % (identity, x, y)
        if covariances is not None:
            text += ", covariance: [%.9g, %.9g, %.9g, %.9g]" % tuple(covariances[i].ravel())
        text += "}\n"
    return text


EVENTS = """stamp,kind,distance,turn,reason
1001.500000000,jump,0.500000,0.200000,"the robot was put there"
1002.000000000,loop_closed,0.300000,0.010000,"1 loop newly believed, 0 loops taken back"
"""
GRAPH = """kind,x0,y0,x1,y1,weight
node,0.0000,0.0000,0.0000,0.0000,1.0000
node,1.0000,0.0000,1.0000,0.0000,1.0000
node,1.0000,1.0000,1.0000,1.0000,1.0000
submap,0.0000,0.0000,0.0000,0.0000,1.0000
motion,0.0000,0.0000,1.0000,0.0000,1.0000
motion,1.0000,0.0000,1.0000,1.0000,1.0000
loop,0.0000,0.0000,1.0000,1.0000,0.5000
"""


def update_lines(stamps, covariances, nis, dof, landmarks):
    """Text of updates.csv."""
    text = ("stamp,cov_xx,cov_xy,cov_xt,cov_yy,cov_yt,cov_tt,nis,nis_dof,used,gated,added,"
            "unknown,landmarks\n")
    for t, P, value, count in zip(stamps, covariances, nis, dof):
        upper = ",".join("%.12g" % P[i, j] for i in range(3) for j in range(i, 3))
        text += "%.9f,%s,%.9g,%d,%d,0,0,0,%d\n" % (t, upper, value, count, count // 2, landmarks)
    return text


def _odometry(poses, random):
    out = [poses[0]]
    for a, b in zip(poses[:-1], poses[1:]):
        step = se2.compose(se2.inverse(a), b)
        step = step * (1.0 + random.normal(0.012, 0.03)) + [0.0, 0.0, random.normal(0.0003, 0.004)]
        out.append(se2.compose(out[-1], step))
    return np.array(out)


def _smooth_noise(count, random, memory=0.97):
    noise = random.normal(size=(count, 3))
    for i in range(1, count):
        noise[i] = memory * noise[i - 1] + np.sqrt(1.0 - memory ** 2) * noise[i]
    return noise


def make_run(folder, seed=1, count=1500, truth=True, landmarks=18, optimism=1.0, gap=True):
    """Write a run. optimism > 1: the filter claims so much less error than it has."""
    random = np.random.default_rng(seed)
    true = ring(count)
    stamps = 1000.0 + STEP * np.arange(count)
    sigma = np.array([0.05, 0.04, 0.015]) * (1.0 + 0.6 * np.sin(
        np.linspace(0.0, 19.0, count)))[:, None] * np.minimum(1.0, 0.02 * np.arange(count))[:, None]
    estimate = true + sigma * _smooth_noise(count, random)
    estimate[:, 2] = se2.wrap_angle(estimate[:, 2])
    P = np.einsum("ni,ij->nij", (sigma / optimism) ** 2, np.eye(3))
    dof = 2 * random.integers(0, 5, count)
    nis = np.array([random.chisquare(k) if k else 0.0 for k in dof]) * optimism
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "trajectory.tum").write_text(tum_lines(stamps, estimate))
    (folder / "odometry.tum").write_text(tum_lines(stamps, _odometry(true, random)))
    (folder / "updates.csv").write_text(update_lines(stamps, P, nis, dof, landmarks))
    (folder / "metrics.json").write_text('{"updates": %d, "update_ms_p50": 0.031, "cpu_s": 0.8, '
                                         '"update_ms_p99": 0.12, "dropped_messages": 0}' % count)
    (folder / "config.yaml").write_text("version: 1\nproduct: ekf_wheel\nrobot: ring\nseed: 1\n"
                                        "ekf:\n  gate_probability: 0.99\n")
    spots = random.uniform([-8.0, -3.0], [8.0, 11.0], (landmarks, 2))
    roots = random.normal(0.0, 0.05, (landmarks, 2, 2))
    spread = roots @ roots.transpose(0, 2, 1) + 4e-4 * np.eye(2)
    seen = spots + np.array([random.multivariate_normal([0, 0], C) for C in spread])
    ids = list(range(6, 6 + landmarks))
    (folder / "landmarks.yaml").write_text(landmark_lines(ids, seen, spread, estimate[-1]))
    if truth:
        keep = np.ones(count, dtype=bool)
        keep[count // 2:count // 2 + 40] = not gap
        world = se2.transform_poses(T_WORLD_MAP, true)
        (folder / "ground_truth.tum").write_text(tum_lines(stamps[keep], world[keep]))
        (folder / "ground_truth_landmarks.yaml").write_text(
            landmark_lines(ids, se2.transform_points(T_WORLD_MAP, spots)))
