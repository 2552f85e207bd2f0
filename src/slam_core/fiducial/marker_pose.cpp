// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/marker_pose.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace slam::fiducial {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector8d = Eigen::Matrix<double, 8, 1>;

/// One maximum of the likelihood as a Gaussian of the position.
struct Peak {
  Eigen::Vector3d position;
  Eigen::Matrix3d covariance;
  double width;  ///< volume of the peak over its height, up to a factor common to all
};

/// The mean of what noise of the pose adds to the projected corners in second order, from
/// differences along the axes of the covariance. Where an axis is so long that the second order
/// alone would explain the noise the covariance overestimates it: what it adds is limited.
std::optional<Vector8d> meanCurvature(const SquareView& view, const RefinedPose& pose,
                                      const Vector8d& error, const Matrix6d& covariance,
                                      double sigma) {
  constexpr double kLargestTurn = 0.3;   // [rad], beyond it the second order says nothing
  constexpr double kLargestShare = 0.4;  // of sigma; from simulation, see marker_pose_test
  const Matrix6d axes = covariance.llt().matrixL();
  Vector8d sum = Vector8d::Zero();
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double turn = axes.col(i).tail<3>().norm();
    const Eigen::Matrix<double, 6, 1> step = std::min(1.0, kLargestTurn / turn) * axes.col(i);
    const auto ahead = reprojectionError(view, moved(pose.T_camera_marker, step));
    const auto behind = reprojectionError(view, moved(pose.T_camera_marker, -step));
    if (!ahead || !behind) return std::nullopt;
    const Vector8d mean = 0.5 * (*ahead + *behind) - error;
    sum += std::min(1.0, kLargestShare * sigma / mean.norm()) * mean;
  }
  return sum;
}

/// Nothing when the corners leave a direction of the pose open.
std::optional<Peak> peakOf(const SquareView& view, const RefinedPose& pose, double sigma) {
  if (!std::isfinite(pose.squared_error)) return std::nullopt;
  const Eigen::LDLT<Matrix6d> information(pose.information);
  const double volume = information.vectorD().prod();
  const Matrix6d covariance = sigma * sigma * information.solve(Matrix6d::Identity());
  if (!(volume > 0.0) || !covariance.allFinite()) return std::nullopt;
  Eigen::Matrix<double, 8, 6> J;
  const auto error = reprojectionError(view, pose.T_camera_marker, &J);
  const auto curvature = meanCurvature(view, pose, *error, covariance, sigma);
  if (!curvature) return std::nullopt;
  const Eigen::Vector3d bias = -information.solve(J.transpose() * *curvature).head<3>();
  return Peak{pose.T_camera_marker.translation() - bias,
              covariance.topLeftCorner<3, 3>() + bias * bias.transpose(), 1.0 / std::sqrt(volume)};
}

/// Mean and covariance of both peaks together.
void mix(const Peak& better, const std::optional<Peak>& other, double sigma, MarkerPose& pose) {
  pose.position = better.position;
  pose.covariance = better.covariance;
  if (!other) return;
  const double excess = pose.solutions[1].squared_error - pose.solutions[0].squared_error;
  const double weight = other->width / better.width * std::exp(-0.5 * excess / (sigma * sigma));
  const double share = weight / (1.0 + weight);
  const Eigen::Vector3d apart = other->position - better.position;
  pose.position += share * apart;
  pose.covariance = (1.0 - share) * better.covariance + share * other->covariance +
                    share * (1.0 - share) * apart * apart.transpose();
}

}  // namespace

double MarkerPose::reprojectionError() const { return std::sqrt(solutions[0].squared_error / 4.0); }

double MarkerPose::obliqueness() const {
  const auto& T = solutions[0].T_camera_marker;
  const double cosine = -T.linear().col(2).dot(T.translation().normalized());
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

std::optional<MarkerPose> estimatePose(const CameraModel& camera, const Corners& corners,
                                       double size, double corner_sigma) {
  Corners on_plane;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto point = camera.unproject(corners[i]);
    if (!point) return std::nullopt;
    on_plane[i] = *point;
  }
  const auto starts = posesOfSquare(on_plane, size);
  if (!starts) return std::nullopt;

  const SquareView view{camera, corners, cornersOfSquare(size)};
  MarkerPose pose;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto refined = refinePose(view, (*starts)[i]);
    pose.solutions[i].squared_error = std::numeric_limits<double>::infinity();
    if (refined) pose.solutions[i] = *refined;
  }
  if (pose.solutions[1].squared_error < pose.solutions[0].squared_error)
    std::swap(pose.solutions[0], pose.solutions[1]);
  if (!std::isfinite(pose.solutions[0].squared_error)) return std::nullopt;

  const auto better = peakOf(view, pose.solutions[0], corner_sigma);
  const auto other = peakOf(view, pose.solutions[1], corner_sigma);
  if (!better) return std::nullopt;
  mix(*better, other, corner_sigma, pose);
  return pose;
}

}  // namespace slam::fiducial
