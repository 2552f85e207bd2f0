// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/gyro/odometry_beside_gyro.hpp"
#include "slam_core/laser_odometry/laser_odometry.hpp"

namespace slam::laser_odometry {

/// Laser odometry to which a gyro says how far the robot has turned: where to look, and the turn
/// where the scans do not show it.
///
/// Counted: as LaserOdometry and as the gyro (GyroBeside).
class LaserImuOdometry final : public gyro::OdometryBesideGyro<LaserOdometry, LaserScan> {
 public:
  LaserImuOdometry() : OdometryBesideGyro("the laser") {}
  void describe(Ports& ports) override;

 private:
  bool isMeasured() const override { return source().isMeasured(); }
};

}  // namespace slam::laser_odometry
