// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_gap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam {
namespace {

/// Increments of which a rate is made: what a shorter one has at least, a floor, would make it
/// large.
constexpr Duration kSpan = std::chrono::milliseconds(100);
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

double way(const Eigen::Matrix3d& covariance) { return covariance.topLeftCorner<2, 2>().trace(); }

/// The worse of both by its way, and by its turn, which have no unit in common.
Eigen::Matrix3d worse(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Matrix3d& by_way = way(b) > way(a) ? b : a;
  const double turn = std::max(a(2, 2), b(2, 2));
  const Eigen::Vector3d growth(1.0, 1.0, std::sqrt(turn / by_way(2, 2)));
  return growth.asDiagonal() * by_way * growth.asDiagonal();
}

}  // namespace

bool MotionGap::bridge(Motion& motion) {
  if (last_ && isLate(*last_, motion)) return false;
  const auto before = std::exchange(last_, motion);
  learnRate(motion);
  learnScales(motion);
  if (!before || !isGap(*before, motion)) return false;
  motion = joined(across(*before, motion), motion);
  return true;
}

/// Until there is a whole span a part of one must do.
void MotionGap::learnRate(const Motion& motion) {
  span_ += motion.end - motion.start;
  span_covariance_ += motion.covariance;
  const bool is_whole = span_ >= kSpan;
  if (!is_whole && knows_rate_) return;
  const Eigen::Matrix3d rate = span_covariance_ / seconds(span_);
  worst_rate_ = knows_rate_ ? worse(worst_rate_, rate) : rate;
  if (!is_whole) return;
  knows_rate_ = true;
  span_ = {};
  span_covariance_.setZero();
}

void MotionGap::learnScales(const Motion& motion) {
  const Eigen::Vector3d told = motion.increment.log();
  const Eigen::Vector3d measured = motion.odometry_start.between(motion.odometry_end).log();
  way_scale_.add(told.head<2>().dot(measured.head<2>()), measured.head<2>().squaredNorm());
  turn_scale_.add(told.z() * measured.z(), measured.z() * measured.z());
}

Pose2 MotionGap::scaled(const Pose2& measured) const {
  Eigen::Vector3d twist = measured.log();
  twist.head<2>() *= way_scale_.value();
  twist.z() *= turn_scale_.value();
  return Pose2::exp(twist);
}

Motion MotionGap::across(const Motion& before, const Motion& after) const {
  Motion rest = before;
  rest.start = before.end;
  rest.end = after.start;
  rest.odometry_start = before.odometry_end;
  rest.odometry_end = after.odometry_start;
  rest.increment = scaled(rest.odometry_start.between(rest.odometry_end));
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
