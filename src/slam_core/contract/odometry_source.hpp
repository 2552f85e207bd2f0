// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// One message of a wheel driver.
struct OdometrySample {
  Stamp stamp;
  std::optional<Pose2> pose;                        ///< T_odom_base, where the driver integrates
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();  ///< vx, vy, omega in base [m/s, m/s, rad/s]
  Eigen::Matrix3d twist_covariance = Eigen::Matrix3d::Zero();
  std::string odometry_frame, base_frame;
};

/// The role of an idiothetic source: raw data in, motion increments with complete covariance out
/// (thesis 3.4.1). One execute() after each set(); at most one motion comes of it.
class OdometrySource {
 public:
  static constexpr const char* kRole = "odometry source";

  virtual ~OdometrySource() = default;

  /// A fresh start. @throw ConfigError listing all faults of its section
  virtual void configure(Settings& settings) = 0;
  virtual void set(const OdometrySample& sample) = 0;
  virtual Status execute() = 0;
  /// Of the last execute(); nothing after the first sample or a bad one.
  virtual const std::optional<Motion>& motion() const = 0;
  virtual const Counters& counters() const = 0;
  virtual void reset() = 0;
};

}  // namespace slam
