// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/pose_refinement.hpp"

#include <Eigen/Cholesky>

namespace slam::fiducial {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Vector8d = Eigen::Matrix<double, 8, 1>;
using Matrix86d = Eigen::Matrix<double, 8, 6>;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace

Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& step) {
  Eigen::Isometry3d result = pose;
  result.translation() += step.head<3>();
  const double angle = step.tail<3>().norm();
  if (angle > 0.0)
    result.linear() = Eigen::AngleAxisd(angle, step.tail<3>() / angle) * pose.linear();
  return result;
}

std::optional<Vector8d> reprojectionError(const SquareView& view,
                                          const Eigen::Isometry3d& T_camera_marker, Matrix86d* J) {
  Vector8d error;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    const Eigen::Vector3d turned = T_camera_marker.linear() * view.square[i];
    Eigen::Matrix<double, 2, 3> J_pixel_point;
    const auto pixel = view.camera.project(turned + T_camera_marker.translation(),
                                           J == nullptr ? nullptr : &J_pixel_point);
    if (!pixel) return std::nullopt;
    error.segment<2>(row) = *pixel - view.corners[i];
    if (J == nullptr) continue;
    J->block<2, 3>(row, 0) = J_pixel_point;
    J->block<2, 3>(row, 3) = -J_pixel_point * crossMatrix(turned);
  }
  return error;
}

std::optional<RefinedPose> refinePose(const SquareView& view,
                                      const Eigen::Isometry3d& T_camera_marker) {
  constexpr int kMaxIterations = 30;
  constexpr double kGain = 1e-10;  // relative, below which the minimum is reached
  RefinedPose best;
  best.T_camera_marker = T_camera_marker;
  Matrix86d J;
  auto error = reprojectionError(view, T_camera_marker, &J);
  if (!error) return std::nullopt;
  best.squared_error = error->squaredNorm();
  best.information = J.transpose() * J;
  double damping = 1e-6;
  for (int i = 0; i < kMaxIterations && damping < 1e6; ++i) {
    Eigen::Matrix<double, 6, 6> damped = best.information;
    damped.diagonal() *= 1.0 + damping;
    const Vector6d step = -damped.ldlt().solve(J.transpose() * *error);
    const auto pose = moved(best.T_camera_marker, step);
    Matrix86d J_there;
    const auto there = reprojectionError(view, pose, &J_there);
    if (!there || !(there->squaredNorm() <= best.squared_error)) {
      damping *= 10.0;
      continue;
    }
    const double gain = best.squared_error - there->squaredNorm();
    best.T_camera_marker = pose;
    best.squared_error = there->squaredNorm();
    error = there;
    J = J_there;
    best.information = J.transpose() * J;
    damping *= 0.1;
    if (gain <= kGain * best.squared_error || best.squared_error < 1e-18) break;
  }
  return best;
}

}  // namespace slam::fiducial
