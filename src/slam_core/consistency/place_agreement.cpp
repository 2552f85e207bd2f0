// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/place_agreement.hpp"

#include <cmath>

namespace slam {
namespace {

constexpr double kSamePosition = 0.15;  // [m]
constexpr double kSameHeading = 0.1;    // [rad]
// The way or turn over which images have to agree. It is larger than what counts as the same place,
// so that a picture that stays the same never agrees with odometry.
constexpr double kLeastWay = 0.2;    // [m]
constexpr double kLeastTurn = 0.15;  // [rad]
static_assert(kLeastWay > kSamePosition && kLeastTurn > kSameHeading);
constexpr int kEnoughInARow = 3;

bool areNear(const Pose2& a, const Pose2& b, double distance, double turn) {
  const Pose2 apart = a.between(b);
  return apart.position().norm() <= distance && std::abs(apart.theta()) <= turn;
}

}  // namespace

bool PlaceAgreement::add(const Pose2& place) {
  if (!first_ || !areNear(*first_ * way_, place, kSamePosition, kSameHeading)) {
    first_ = place;
    way_ = Pose2();
    in_a_row_ = 1;
    return false;
  }
  ++in_a_row_;
  return in_a_row_ >= kEnoughInARow && !areNear(Pose2(), way_, kLeastWay, kLeastTurn);
}

}  // namespace slam
