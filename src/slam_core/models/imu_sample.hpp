// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/time.hpp"

namespace slam {

/// What an IMU says of the robot's rotation, whatever its mount.
struct ImuSample {
  Stamp stamp;
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< of and in the base [rad/s]
  /// The driver's, turned into the base [rad^2/s^2]; it is zero where the driver gives none.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, angular_velocity, covariance);
  }
};

}  // namespace slam
