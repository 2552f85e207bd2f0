// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/wheels_beside.hpp"
#include "slam_core/laser_odometry/laser_odometry.hpp"

namespace slam::laser_odometry {

/// Laser odometry to which the wheels say where to look, and how far the robot has gone where the
/// scans do not tell it.
///
/// Counted: as LaserOdometry and as the wheels (WheelsBeside).
class LaserWheelOdometry final : public OdometrySource {
 public:
  LaserWheelOdometry();

  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  Status execute() override;
  bool isBusy() const override { return is_handing_over_; }

  const std::optional<Motion>& motion() const override { return laser_.motion(); }
  std::string name() const override { return laser_.name(); }
  Counters counters() const override;
  std::uint64_t dropped() const override { return wheels_.dropped(); }
  Figures figures() const override { return laser_.figures(); }
  void reset() override;
  void goOnLive() override { reset(); }
  bool canResume() const override { return wheels_.canResume(); }
  void saveState(ArchiveWriter& archive) const override {
    archive(wheels_, laser_, is_handing_over_);
  }
  void restoreState(ArchiveReader& archive) override { archive(wheels_, laser_, is_handing_over_); }

 private:
  WheelsBeside<LaserScan> wheels_;
  LaserOdometry laser_;
  bool is_handing_over_ = false;
};

}  // namespace slam::laser_odometry
