// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/image.hpp"
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
/// (thesis 3.4.1). After each set() come execute() and, while isBusy(), further ones; at most one
/// motion comes of each. A source takes in what it names in usesWheels() and usesImages(); nothing
/// comes of other inputs.
class OdometrySource {
 public:
  static constexpr const char* kRole = "odometry source";

  virtual ~OdometrySource() = default;

  /// A fresh start. @throw ConfigError listing all faults of its section
  virtual void configure(Settings& settings) = 0;
  /// Of the random streams; after configure().
  virtual void seed(std::uint64_t /*seed*/) {}

  virtual bool usesWheels() const { return true; }
  virtual bool usesImages() const { return false; }

  virtual void set(const OdometrySample& /*sample*/) {}
  /// Calibration and mount are in force for all images that have not been processed; images wait,
  /// bounded, until both are known.
  virtual void set(const CameraCalibration& /*calibration*/) {}
  virtual void set(const CameraMount& /*mount*/) {}
  virtual void set(const Image& /*image*/) {}

  virtual Status execute() = 0;
  /// Whether the last execute() took in one of several inputs that may wait.
  virtual bool isBusy() const { return false; }
  /// Of the last execute(); nothing after the first sample or a bad one.
  virtual const std::optional<Motion>& motion() const = 0;
  virtual const Counters& counters() const = 0;
  /// What the last execute() saw, in colour (CV_8UC3), made when it is asked for; empty where there
  /// is nothing to show.
  virtual cv::Mat drawing() const { return {}; }
  /// Names and values that tell how well it goes, for diagnostics.
  virtual std::vector<std::pair<std::string, double>> figures() const { return {}; }
  virtual void reset() = 0;
};

}  // namespace slam
