# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error figures of a run. Every definition stands in KEYS, which the report prints."""
import dataclasses
from typing import Optional

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.landmarks import match_by_id
from slam_eval.io.trajectory import at_stamps, interpolate
from slam_eval.metrics.chi_square import two_sided_bounds
from slam_eval.metrics.drift import Drift, segment_drift
from slam_eval.metrics.honesty import (
    DOUBTFUL, false_losses, frame_of_map, LOST, position_claim, PositionClaim, seconds_in,
    truth_in_map)
from slam_eval.metrics.landmark_detection import landmark_detection, LandmarkDetection
from slam_eval.metrics.map_agreement import MapAgreement
from slam_eval.metrics.place_recognition import place_recognition, PlaceRecognition
from slam_eval.metrics.relations import RelationErrors
from slam_eval.metrics.relative_error import relative_metrics

# A covariance whose smallest eigenvalue is not above this says nothing about an error.
_SINGULAR = 1e-18


@dataclasses.dataclass
class TrajectoryError:
    """Translation errors [m] of the poses that have truth, after the rigid alignment to truth."""

    T_truth_map: np.ndarray
    valid: np.ndarray
    errors: np.ndarray

    @property
    def rmse(self):
        return float(np.sqrt(np.mean(self.errors ** 2)))

    @property
    def max(self):
        return float(np.max(self.errors))


@dataclasses.dataclass
class LandmarkError:
    """Matched landmarks: ids, errors [m] and the rigid alignment of the map to truth."""

    T_truth_map: np.ndarray
    ids: list
    errors: np.ndarray

    @property
    def rmse(self):
        return float(np.sqrt(np.mean(self.errors ** 2)))


@dataclasses.dataclass
class PoseConsistency:
    """Pose errors (dx [m], dy [m], dtheta [rad]) in the map frame, their NEES, per valid line."""

    valid: np.ndarray
    errors: np.ndarray
    sigmas: np.ndarray
    nees: np.ndarray


@dataclasses.dataclass
class Evaluation:
    """Everything that was computed; None where the run has not what it takes."""

    ate: Optional[TrajectoryError] = None
    unaligned: Optional[TrajectoryError] = None
    final_ate: Optional[TrajectoryError] = None
    scale_error: Optional[float] = None
    odometry_ate: Optional[TrajectoryError] = None
    odometry_drift: Optional[Drift] = None
    wheels_ate: Optional[TrajectoryError] = None
    wheels_drift: Optional[Drift] = None
    landmark_error: Optional[LandmarkError] = None
    detection: Optional[LandmarkDetection] = None
    consistency: Optional[PoseConsistency] = None
    claim: Optional[PositionClaim] = None
    places: Optional[PlaceRecognition] = None
    relations: Optional[RelationErrors] = None
    agreement: Optional[MapAgreement] = None
    metrics: dict = dataclasses.field(default_factory=dict)


def position_error(trajectory, truth):
    """ATE at true positions without headings, such as GPS fixes: the trajectory is interpolated to
    each of them and carried to the point of the robot that they are of. None where fewer than two
    fixes lie within the trajectory."""
    poses, valid = interpolate(trajectory, truth.stamps)
    if np.count_nonzero(valid) < 2:
        return None
    estimate = np.array([se2.compose(pose, (*truth.point, 0.0))[:2] for pose in poses[valid]])
    true = truth.poses[valid, :2]
    T = se2.align_rigid(estimate, true)
    errors = np.linalg.norm(se2.transform_points(T, estimate) - true, axis=1)
    return TrajectoryError(T, valid, errors)


def trajectory_error(trajectory, truth, align=True):
    """ATE of a trajectory, or None where fewer than two poses have truth. Without alignment the map
    lies in truth where frame_of_map() says, as for NEES; truth without headings has none."""
    if not truth.has_heading:
        return position_error(trajectory, truth) if align else None
    true, valid = interpolate(truth, trajectory.stamps)
    if np.count_nonzero(valid) < 2:
        return None
    estimate, true = trajectory.poses[valid, :2], true[valid, :2]
    T = se2.align_rigid(estimate, true) if align else frame_of_map(trajectory, truth)
    errors = np.linalg.norm(se2.transform_points(T, estimate) - true, axis=1)
    return TrajectoryError(T, valid, errors)


def scale_error(trajectory, truth):
    """How much too large the path is, as a share: 1 / s - 1 of the similarity that moves it onto
    truth. None where it cannot be told."""
    true, valid = interpolate(truth, trajectory.stamps)
    if not truth.has_heading or np.count_nonzero(valid) < 2:
        return None
    scale = se2.similarity_scale(trajectory.poses[valid, :2], true[valid, :2])
    return None if scale is None else 1.0 / scale - 1.0


def landmark_error(estimate, truth, align=True):
    """Landmark errors, after their own rigid alignment unless the frames are the same; or None with
    fewer matches than that takes."""
    ids, positions, true = match_by_id(estimate, truth)
    if len(ids) < (2 if align else 1):
        return None
    T = se2.align_rigid(positions, true) if align else np.zeros(3)
    errors = np.linalg.norm(se2.transform_points(T, positions) - true, axis=1)
    return LandmarkError(T, ids, errors)


def pose_consistency(trajectory, updates, truth):
    """Errors against the filter's own covariance; truth lies where frame_of_map() says, no fit. None
    where truth has no headings, or fewer than two poses have truth and a covariance."""
    moved = truth_in_map(trajectory, truth)
    if moved is None:
        return None
    true, valid = moved
    errors = trajectory.poses - true
    errors[:, 2] = se2.wrap_angle(errors[:, 2])
    P = updates.covariances
    valid = valid & (np.linalg.eigvalsh(P)[:, 0] > _SINGULAR)
    if np.count_nonzero(valid) < 2:  # the first one is right by definition
        return None
    errors, P = errors[valid], P[valid]
    nees = np.einsum("ni,ni->n", errors, np.linalg.solve(P, errors[:, :, None])[:, :, 0])
    sigmas = np.sqrt(np.einsum("nii->ni", P))
    return PoseConsistency(valid, errors, sigmas, nees)


def nis_mean(updates):
    """Sum of NIS over the sum of its degrees of freedom; None without any used observation."""
    dof = int(np.sum(updates.nis_dof))
    return float(np.sum(updates.nis) / dof) if dof > 0 else None


def inside_bounds(values, dof, probability=0.95):
    """Which values lie inside the two-sided chi-square bounds of their own degrees of freedom."""
    bounds = {int(k): two_sided_bounds(int(k), probability) for k in np.unique(dof)}
    low, high = np.array([bounds[int(k)] for k in dof]).T
    return (values >= low) & (values <= high)


def evaluate(run, relations=None, agreement=None):
    """Compute what the run's files allow.

    relations, agreement: its RelationErrors and MapAgreement, where there is a reference.
    """
    result = Evaluation(relations=relations, agreement=agreement)
    if run.truth is not None:
        result.ate = trajectory_error(run.trajectory, run.truth)
        result.unaligned = trajectory_error(run.trajectory, run.truth, align=False)
        result.scale_error = scale_error(run.trajectory, run.truth)
        if run.final is not None:
            result.final_ate = trajectory_error(run.final, run.truth)
        if run.odometry is not None:
            result.odometry_ate = trajectory_error(run.odometry, run.truth)
            result.odometry_drift = segment_drift(run.odometry, run.truth)
        if run.wheels is not None:
            wheels = at_stamps(run.wheels, run.trajectory.stamps)
            result.wheels_ate = trajectory_error(wheels, run.truth)
            result.wheels_drift = segment_drift(wheels, run.truth)
        if run.places is not None:
            result.places = place_recognition(run.places, run.truth)
        if run.updates is not None:
            result.consistency = pose_consistency(run.trajectory, run.updates, run.truth)
            result.claim = position_claim(run.trajectory, run.updates, run.truth)
    if run.landmarks is not None and run.true_landmarks is not None:
        result.landmark_error = landmark_error(run.landmarks, run.true_landmarks)
        result.detection = _detection(run, result)
    result.metrics = _collect(run, result)
    return result


def _detection(run, result):
    """The path's alignment comes first: it needs no ids, and wrong landmarks do not bend it."""
    path = None if run.truth_is_given else result.final_ate or result.ate
    alignment = path or result.landmark_error
    return alignment and landmark_detection(run.landmarks, run.true_landmarks,
                                            alignment.T_truth_map)


def _drift(name, drift):
    return {f"{name}_drift_percent": drift and 100.0 * drift.translation,
            f"{name}_drift_deg_per_m": drift and float(np.degrees(drift.rotation_rad_per_m))}


def _collect(run, result):
    values = {
        "ate_rmse_m": result.ate and result.ate.rmse,
        "ate_max_m": result.ate and result.ate.max,
        "ate_unaligned_rmse_m": result.unaligned and result.unaligned.rmse,
        "scale_error": result.scale_error,
        **(relative_metrics(run.trajectory, run.truth) if run.truth is not None else {}),
        "ate_final_rmse_m": result.final_ate and result.final_ate.rmse,
        "odometry_ate_rmse_m": result.odometry_ate and result.odometry_ate.rmse,
        **_drift("odometry", result.odometry_drift),
        "wheel_odometry_ate_rmse_m": result.wheels_ate and result.wheels_ate.rmse,
        **_drift("wheel_odometry", result.wheels_drift),
        "landmark_rmse_m": result.landmark_error and result.landmark_error.rmse,
        **(result.detection.metrics if result.detection else {}),
        "landmarks": None if run.landmarks is None else len(run.landmarks),
        "nees_mean": result.consistency and float(np.mean(result.consistency.nees)),
        "nis_mean": None if run.updates is None else nis_mean(run.updates),
        "confidently_wrong_s": result.claim and result.claim.seconds_wrong,
        "lost_s": seconds_in(LOST, run),
        "lost_missed": result.claim and result.claim.missed_losses,
        "lost_false": false_losses(result.claim, run),
        "doubtful_s": seconds_in(DOUBTFUL, run),
        **(result.places.metrics if result.places else {}),
        **(result.relations.metrics if result.relations else {}),
        **(result.agreement.metrics if result.agreement else {}),
        "map_area_m2": run.grid and run.grid.known_area,
        "points": None if run.points is None else len(run.points),
    }
    return {key: value for key, value in values.items() if value is not None}
