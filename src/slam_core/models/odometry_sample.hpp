// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// One message of a wheel driver.
struct OdometrySample {
  Stamp stamp;
  std::optional<Pose2> pose;                        ///< T_odom_base, where the driver integrates
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();  ///< vx, vy, omega in base [m/s, m/s, rad/s]
  Eigen::Matrix3d twist_covariance = Eigen::Matrix3d::Zero();
  std::string odometry_frame, base_frame;

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, pose, twist, twist_covariance, odometry_frame, base_frame);
  }
};

}  // namespace slam
