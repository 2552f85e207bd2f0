// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_gap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam {
namespace {

constexpr double kStep = 0.1;     // [s] of the pieces in which errors of heading carry on
constexpr int kMostSteps = 1000;  // of longer gaps the pieces are longer

/// Older than that by more, it is the first of a new run.
bool isLate(const Motion& before, const Motion& after) {
  return after.end <= before.end && after.end > before.end - kStampJump;
}

bool isGap(const Motion& before, const Motion& after) {
  return after.sequence > before.sequence + 1 && after.start > before.end &&
         after.odometry_frame == before.odometry_frame && after.base_frame == before.base_frame;
}

}  // namespace

bool MotionGap::bridge(Motion& motion) {
  if (last_ && isLate(*last_, motion)) return false;
  const auto before = std::exchange(last_, motion);
  const Eigen::Matrix3d rate = motion.covariance / seconds(motion.end - motion.start);
  if (rate.trace() > worst_rate_.trace()) worst_rate_ = rate;
  if (!before || !isGap(*before, motion)) return false;
  motion = joined(across(*before, motion), motion);
  return true;
}

Motion MotionGap::across(const Motion& before, const Motion& after) const {
  Motion rest = before;
  rest.start = before.end;
  rest.end = after.start;
  rest.odometry_start = before.odometry_end;
  rest.odometry_end = after.odometry_start;
  rest.increment = rest.odometry_start.between(rest.odometry_end);
  const double time = seconds(rest.end - rest.start);
  rest.covariance = time * worst_rate_;
  std::optional<Motion> sum;
  for (int left = std::clamp(static_cast<int>(std::ceil(time / kStep)), 1, kMostSteps); left > 1;
       --left) {
    auto [piece, after_piece] = split(rest, rest.start + (rest.end - rest.start) / left);
    sum = sum ? joined(*sum, piece) : piece;
    rest = after_piece;
  }
  return sum ? joined(*sum, rest) : rest;
}

}  // namespace slam
