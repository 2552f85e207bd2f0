// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu_odometry/standstill.hpp"

#include <cmath>

namespace slam::imu_odometry {
namespace {

/// Below which wheels stand: drivers that filter their encoders do not come to 0.
constexpr double kRestingSpeed = 0.002;     // [m/s]
constexpr double kRestingTurnRate = 0.002;  // [rad/s]

}  // namespace

void Standstill::add(const Motion& wheels) {
  const double dt = seconds(wheels.end - wheels.start);
  const bool moves = wheels.increment.position().norm() > kRestingSpeed * dt ||
                     std::abs(wheels.increment.theta()) > kRestingTurnRate * dt;
  rested_ = moves ? Duration{} : rested_ + (wheels.end - wheels.start);
  has_moved_ = has_moved_ || moves;
}

}  // namespace slam::imu_odometry
