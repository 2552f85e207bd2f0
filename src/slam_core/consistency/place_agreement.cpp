// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/place_agreement.hpp"

#include <cmath>

namespace slam {
namespace {

constexpr double kSamePosition = 0.15;  // [m]
constexpr double kSameHeading = 0.1;    // [rad]
constexpr int kEnoughInARow = 3;

}  // namespace

bool PlaceAgreement::add(const Pose2& place) {
  bool is_same = false;
  if (pose_) {
    const Pose2 apart = pose_->between(place);
    is_same = apart.position().norm() <= kSamePosition && std::abs(apart.theta()) <= kSameHeading;
  }
  in_a_row_ = is_same ? in_a_row_ + 1 : 1;
  pose_ = place;
  return in_a_row_ >= kEnoughInARow;
}

}  // namespace slam
