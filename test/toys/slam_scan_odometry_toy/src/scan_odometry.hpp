// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_scan_odometry_toy/scan_alignment.hpp"

namespace slam_toy {

/// Motion from a laser instead of wheels: each scan is aligned with the one before. Where that
/// cannot be done the robot is taken to go on at its velocity, with a covariance to match. Counted:
/// "late", "coasted".
class ScanOdometry final : public slam::OdometrySource {
 public:
  void configure(slam::Settings&) override { reset(); }
  void describe(slam::Ports& ports) override;
  void set(const slam::LaserScan& scan) { scan_ = scan; }
  slam::Status execute() override;
  const std::optional<slam::Motion>& motion() const override { return motion_; }
  slam::Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override { return counters_["late"]; }
  void reset() override;

 private:
  void moveBy(const Alignment& step, slam::Stamp end);

  std::optional<slam::LaserScan> scan_;
  std::optional<slam::Stamp> last_;                  ///< of the scan before
  Points points_;                                    ///< and what it met
  Eigen::Vector3d twist_ = Eigen::Vector3d::Zero();  ///< [m/s, m/s, rad/s]
  slam::Pose2 pose_;                                 ///< T_odom_base
  std::optional<slam::Motion> motion_;
  std::uint64_t sequence_ = 0;
  slam::Counters counters_;
};

}  // namespace slam_toy
