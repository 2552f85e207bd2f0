// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion_model.hpp"
#include "slam_sim/robot_model.hpp"

namespace slam::sim {

/// What the wheels make of the base's motion.
///
/// Systematic: each wheel measures its way with its own scale, and the driver computes the motion
/// with a lever that is not quite the true one (Borenstein and Feng 1996: unequal diameters and
/// uncertain wheelbase). Random: white noise along the way and about the heading with the variances
/// alpha1 d + alpha2 |r| and alpha3 d + alpha4 |r|, an omnidirectional base also across its way;
/// d and r are the way and the angle of an increment.
class WheelEncoders {
 public:
  WheelEncoders(const WheelBase& wheels, const OdometryNoise& noise);

  /// The systematic part: true to measured body twist (vx, vy, omega).
  const Eigen::Matrix3d& systematic() const { return systematic_; }

  /// The twist over unit time [m, m, rad] that is measured of the true one. Standing still is
  /// measured as it is.
  Eigen::Vector3d measure(const Eigen::Vector3d& twist, RandomStream& random) const;

 private:
  Eigen::Matrix3d systematic_;
  OdometryNoise noise_;
};

/// Dead reckoning on the wheels along the true poses that it is given.
class WheelOdometer {
 public:
  explicit WheelOdometer(WheelEncoders encoders) : encoders_(std::move(encoders)) {}

  /// The next true pose, T_world_base. The first one is the odometry's origin.
  void moveTo(const Pose2& truth, RandomStream& random);

  const Pose2& pose() const { return pose_; }                      ///< T_odom_base
  const Eigen::Vector3d& increment() const { return increment_; }  ///< last measured twist

 private:
  WheelEncoders encoders_;
  bool has_started_ = false;
  Pose2 truth_, pose_;
  Eigen::Vector3d increment_ = Eigen::Vector3d::Zero();
};

}  // namespace slam::sim
