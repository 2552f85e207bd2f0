// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/scale_doubt.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

/// What is less than this much beyond the noise is none, since no noise is known exactly.
constexpr double kSmallestScale = 0.05;
constexpr double kSmallestTurn = 0.03;  // [rad]
/// The ways are compared in pieces: the jitter of an odometry that stands still adds up to a way,
/// but leads nowhere.
constexpr double kPiece = 0.3;  // [m]

/// A filter goes between two sensors that contradict each other, which bends its map: a share of
/// what is wrong in one direction is wrong in the other.
constexpr double kBent = 0.5;
/// So far the robot has driven before the difference was noticed, and the filter took both for
/// right: this part of the map is out of place as a whole [m].
constexpr double kUnnoticed = 1.0;

bool isBeyond(double value, double variance, double smallest) {
  constexpr double kStandardDeviations = 3.0;
  return std::abs(value) > smallest + kStandardDeviations * std::sqrt(variance);
}

}  // namespace

void ScaleDoubt::add(const Motion& odometry, const Pose2& estimated) {
  odometry_ = odometry_ ? joined(*odometry_, odometry) : odometry;
  estimated_ = estimated_ * estimated;
  const double way = std::max(odometry_->increment.position().norm(), estimated_.position().norm());
  if (way < kPiece) return;
  add({odometry_->increment.position(), estimated_.position(),
       odometry_->covariance.topLeftCorner<2, 2>()});
  odometry_.reset();
  estimated_ = Pose2();
}

void ScaleDoubt::add(const PieceOfWay& piece) {
  constexpr double kMemory = 5.0;  // of the way, over which older pieces lose their weight [m]
  const auto& [o, e, Q] = piece;
  const Eigen::Vector2d sideways(-o.y(), o.x());
  const double kept = std::exp(-o.norm() / kMemory);
  along_ = kept * along_ + o.dot(e);
  across_ = kept * across_ + sideways.dot(e);
  square_ = kept * square_ + o.squaredNorm();
  variance_along_ = kept * kept * variance_along_ + o.dot(Q * o);
  variance_across_ = kept * kept * variance_across_ + sideways.dot(Q * sideways);
  if (square_ < kPiece * kPiece) return;
  difference_ = {std::hypot(along_, across_) / square_ - 1.0, std::atan2(across_, along_)};
}

ScaleDoubt::Difference ScaleDoubt::beyondNoise() const {
  if (square_ <= 0.0) return {};
  const double square = square_ * square_;
  const auto& [scale, turn] = difference_;
  return {isBeyond(scale, variance_along_ / square, kSmallestScale) ? scale : 0.0,
          isBeyond(turn, variance_across_ / square, kSmallestTurn) ? turn : 0.0};
}

Eigen::Matrix3d covarianceOf(const ScaleDoubt::Difference& doubt,
                             const Eigen::Vector2d& from_start) {
  const Eigen::Vector2d sideways(-from_start.y(), from_start.x());
  const double scale = doubt.scale * doubt.scale, turn = doubt.turn * doubt.turn;
  const double along = scale + kBent * kBent * turn, across = turn + kBent * kBent * scale;
  Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
  P.topLeftCorner<2, 2>() = along * from_start * from_start.transpose() +
                            across * sideways * sideways.transpose() +
                            kUnnoticed * kUnnoticed * (scale + turn) * Eigen::Matrix2d::Identity();
  P(2, 2) = across;
  return P;
}

}  // namespace slam
