// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/speed_limit.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

constexpr double kBurst = 0.1;  // [s]

}  // namespace

double SpeedLimit::shareOf(const Pose2& step, Duration interval) const {
  const double time = seconds(interval) + kBurst;
  return std::max(step.position().stableNorm() / (time * speed_),
                  std::abs(step.theta()) / (time * turn_rate_));
}

bool SpeedLimit::allows(const Eigen::Vector3d& twist) const {
  return twist.head<2>().stableNorm() <= speed_ && std::abs(twist.z()) <= turn_rate_;
}

Eigen::Vector3d SpeedLimit::cut(const Eigen::Vector3d& twist) const {
  Eigen::Vector3d within = twist;
  if (const double speed = twist.head<2>().stableNorm(); speed > speed_)
    within.head<2>() *= speed_ / speed;
  within.z() = std::clamp(twist.z(), -turn_rate_, turn_rate_);
  return within;
}

}  // namespace slam
