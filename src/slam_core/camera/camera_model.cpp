// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_model.hpp"

namespace slam {

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& point,
                                                    Eigen::Matrix<double, 2, 3>* J) const {
  if (!(point.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d on_plane = point.head<2>() / point.z();
  Eigen::Matrix2d J_lens;
  const auto distorted = lens_.distort(on_plane, J == nullptr ? nullptr : &J_lens);
  if (!distorted) return std::nullopt;
  const Eigen::Array2d focal(calibration_.fx, calibration_.fy);
  if (J != nullptr) {
    Eigen::Matrix<double, 2, 3> J_plane;
    J_plane << 1.0, 0.0, -on_plane.x(), 0.0, 1.0, -on_plane.y();
    *J = focal.matrix().asDiagonal() * J_lens * J_plane / point.z();
  }
  return focal * distorted->array() + Eigen::Array2d(calibration_.cx, calibration_.cy);
}

std::optional<Eigen::Vector2d> CameraModel::unproject(const Eigen::Vector2d& pixel) const {
  return lens_.undistort({(pixel.x() - calibration_.cx) / calibration_.fx,
                          (pixel.y() - calibration_.cy) / calibration_.fy});
}

}  // namespace slam
