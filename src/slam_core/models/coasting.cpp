// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/coasting.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

constexpr Duration kShortestSpan = std::chrono::milliseconds(100);
constexpr double kToAnySpeed = 0.25;  // [s]
constexpr double kLeastSpeed = 0.1;   // of the largest speed [m/s] and turn rate [rad/s]
constexpr double kMostDoubt = 1e3;    // [m], that a covariance stays one

}  // namespace

void Coasting::add(const Pose2& increment, Duration interval) {
  step_ = step_ * increment;
  span_ += interval;
  if (span_ < kShortestSpan) return;
  velocity_ = step_.log() / seconds(span_);
  largest_speed_ = std::max(largest_speed_, velocity_.head<2>().norm());
  largest_turn_rate_ = std::max(largest_turn_rate_, std::abs(velocity_.z()));
  step_ = Pose2();
  span_ = {};
}

Pose2 Coasting::increment(Duration interval) const {
  return Pose2::exp(seconds(interval) * velocity_);
}

Eigen::Matrix3d Coasting::covariance(Duration interval) const {
  const double dt = seconds(interval), free = dt * std::min(1.0, dt / kToAnySpeed);
  const double way = std::min(kMostDoubt, free * std::max(kLeastSpeed, largest_speed_));
  const double turn = std::min(M_PI, free * std::max(kLeastSpeed, largest_turn_rate_));
  return Eigen::Vector3d(way * way, way * way, turn * turn).asDiagonal();
}

bool Coasting::isUnusual(const Pose2& step, Duration interval) const {
  const double dt = seconds(interval);
  return step.position().norm() > 2.0 * dt * largest_speed_ + kLeastSpeed ||
         std::abs(step.theta()) > 2.0 * dt * largest_turn_rate_ + kLeastSpeed;
}

}  // namespace slam
