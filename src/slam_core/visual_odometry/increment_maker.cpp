// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/increment_maker.hpp"

#include <algorithm>
#include <cmath>

namespace slam::visual_odometry {
namespace {

/// Covariance of a^-1 b where a and b have independent errors of that covariance.
Eigen::Matrix3d covarianceBetween(const Pose2& a, const Eigen::Matrix3d& C_a, const Pose2& b,
                                  const Eigen::Matrix3d& C_b) {
  Eigen::Matrix3d J_inverse, J_a, J_b;
  a.inverse(&J_inverse).compose(b, &J_a, &J_b);
  J_a *= J_inverse;
  return J_a * C_a * J_a.transpose() + J_b * C_b * J_b.transpose();
}

}  // namespace

void IncrementMaker::reset() {
  beginAnew();
  next_sequence_ = 0;
}

void IncrementMaker::beginAnew() {
  velocity_.setZero();
  gap_covariance_.setZero();
}

Motion IncrementMaker::follow(const View& last, const View& now, const Alignment& alignment,
                              const Pose2& T_odom_reference, bool after_gap) {
  const auto Q = covarianceOf(last, now, alignment.covariance, T_odom_reference);
  auto motion = motionBetween(last, now, Q + gap_covariance_);
  gap_covariance_.setZero();
  if (!after_gap) velocity_ = motion.increment.log() / seconds(now.stamp - last.stamp);
  return motion;
}

Motion IncrementMaker::bridge(const View& last, View& now, Stamp gap_begin) {
  auto gap = gap_source_ ? gap_source_(last.stamp, now.stamp) : std::nullopt;
  if (!gap) gap = coast(last.stamp, now.stamp, gap_begin);
  has_turn_ = turnBetween(last.stamp, now.stamp).has_value();
  now.T_odom_base = last.T_odom_base * gap->increment;
  gap_covariance_ += gap->covariance;
  return motionBetween(last, now, gap->covariance);
}

std::string IncrementMaker::instead() const {
  if (gap_source_) return "the wheels' motion is used meanwhile";
  return has_turn_ ? "the last velocity and the gyro are used meanwhile"
                   : "the last velocity is used meanwhile";
}

std::optional<Turn> IncrementMaker::turnBetween(Stamp start, Stamp end) const {
  return turn_source_ ? turn_source_(start, end) : std::nullopt;
}

Pose2 IncrementMaker::expected(const View& from, Stamp stamp) const {
  Eigen::Vector3d twist = seconds(stamp - from.stamp) * velocity_;
  if (const auto turn = turnBetween(from.stamp, stamp)) twist.z() = turn->angle;
  return from.T_odom_base * Pose2::exp(twist);
}

/// The last velocity may be wrong for as long as the gap lasts, so that its error adds up: the
/// standard deviations of the increments come to max_speed times the gap's length, however many
/// images are in it.
GapMotion IncrementMaker::coast(Stamp start, Stamp end, Stamp gap_begin) const {
  const double before = seconds(start - gap_begin), after = seconds(end - gap_begin);
  const double growth = after * after - before * before;  // [s^2]
  const double way2 = growth * config_.max_speed * config_.max_speed;
  const double turn2 = growth * config_.max_turn_rate * config_.max_turn_rate;
  const auto turn = turnBetween(start, end);
  Eigen::Vector3d twist = (after - before) * velocity_;
  if (turn) twist.z() = turn->angle;
  GapMotion gap;
  gap.increment = Pose2::exp(twist);
  gap.covariance.diagonal() << way2, way2, turn ? turn->variance : std::min(turn2, M_PI * M_PI);
  return gap;
}

/// Of the increment to an image that was aligned. The reference's errors are common to this image
/// and the one before, so that they nearly cancel: what remains are the images' own, half of the
/// alignment's each.
Eigen::Matrix3d IncrementMaker::covarianceOf(const View& last, const View& now,
                                             const Eigen::Matrix3d& alignment,
                                             const Pose2& T_odom_reference) const {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = T_odom_reference.rotation();
  const Eigen::Matrix3d own = 0.5 * R * alignment * R.transpose();
  Eigen::Matrix3d Q = covarianceBetween(last.T_odom_base, own, now.T_odom_base, own);
  const double dt = seconds(now.stamp - last.stamp);
  const double way = (now.T_odom_base.position() - last.T_odom_base.position()).norm();
  const double position =
      config_.alpha_translation * way + config_.floor_position * config_.floor_position * dt;
  const double heading =
      config_.alpha_rotation * way + config_.floor_heading * config_.floor_heading * dt;
  Q.diagonal() += Eigen::Vector3d(position, position, heading);
  return Q;
}

Motion IncrementMaker::motionBetween(const View& last, const View& now,
                                     const Eigen::Matrix3d& covariance) {
  Motion motion;
  motion.sequence = next_sequence_++;
  motion.start = last.stamp;
  motion.end = now.stamp;
  motion.increment = last.T_odom_base.between(now.T_odom_base);
  motion.covariance = 0.5 * (covariance + covariance.transpose());
  motion.odometry_start = last.T_odom_base;
  motion.odometry_end = now.T_odom_base;
  return motion;
}

}  // namespace slam::visual_odometry
