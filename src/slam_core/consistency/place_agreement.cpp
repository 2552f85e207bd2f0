// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/place_agreement.hpp"

#include <cmath>

namespace slam {
namespace {

constexpr double kSamePosition = 0.15;  // [m]
constexpr double kSameHeading = 0.1;    // [rad]
// The way or turn after which an image counts as a new one. They are larger than what counts as the
// same place, so that a picture that stays the same never agrees with odometry.
constexpr double kNewPosition = 0.2;  // [m]
constexpr double kNewHeading = 0.15;  // [rad]
static_assert(kNewPosition > kSamePosition && kNewHeading > kSameHeading);
constexpr int kEnoughInARow = 3;

bool areNear(const Pose2& a, const Pose2& b, double distance, double turn) {
  const Pose2 apart = a.between(b);
  return apart.position().norm() <= distance && std::abs(apart.theta()) <= turn;
}

}  // namespace

bool PlaceAgreement::add(const Pose2& place) {
  if (place_ && areNear(Pose2(), way_, kNewPosition, kNewHeading)) return false;
  const bool is_same = place_ && areNear(*place_ * way_, place, kSamePosition, kSameHeading);
  in_a_row_ = is_same ? in_a_row_ + 1 : 1;
  place_ = place;
  way_ = Pose2();
  return in_a_row_ >= kEnoughInARow;
}

}  // namespace slam
