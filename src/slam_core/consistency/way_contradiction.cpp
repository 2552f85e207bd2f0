// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/way_contradiction.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam {
namespace {

constexpr double kPieceOfWay = 0.3;   // [m]
constexpr double kPieceOfTurn = 0.3;  // [rad]
/// A way of this length is a piece although nothing turned [m].
constexpr double kStraight = 1.5;
/// So many contradictory pieces in a row are evidence, and so many that agree end it.
constexpr int kEvident = 2, kOver = 7;

/// Whether two motions differ by more than half of the larger one, or of a piece, and by more than
/// noise.
bool exclude(double first, double second, double difference, double variance, double piece) {
  constexpr double kShare = 0.5, kStandardDeviations = 4.0;
  const double larger = std::max({std::abs(first), std::abs(second), piece});
  return difference > kShare * larger && difference > kStandardDeviations * std::sqrt(variance);
}

double wayOf(const Pose2& first, const Pose2& second) {
  return std::max(first.position().norm(), second.position().norm());
}

}  // namespace

void WayContradiction::Piece::add(const Motion& next, const Pose2& next_estimated) {
  odometry = joined(odometry, next);
  estimated = estimated * next_estimated;
}

bool WayContradiction::isWay(const Piece& piece) {
  return wayOf(piece.odometry.increment, piece.estimated) >= kPieceOfWay;
}

bool WayContradiction::isTurn(const Piece& piece) {
  const auto &driven = piece.odometry.increment, &estimated = piece.estimated;
  return std::max(std::abs(driven.theta()), std::abs(estimated.theta())) >= kPieceOfTurn ||
         wayOf(driven, estimated) >= kStraight;
}

bool WayContradiction::haveContradictoryWays(const Piece& piece) {
  const auto driven = piece.odometry.increment.position(), estimated = piece.estimated.position();
  const auto& Q = piece.odometry.covariance;
  return exclude(driven.norm(), estimated.norm(), (driven - estimated).norm(), Q(0, 0) + Q(1, 1),
                 kPieceOfWay);
}

bool WayContradiction::haveContradictoryTurns(const Piece& piece) {
  const double turned = piece.odometry.increment.theta(), estimated = piece.estimated.theta();
  return exclude(turned, estimated, std::abs(wrapAngle(turned - estimated)),
                 piece.odometry.covariance(2, 2), kPieceOfTurn);
}

void WayContradiction::Comparison::add(const Motion& odometry, const Pose2& estimated) {
  if (piece_)
    piece_->add(odometry, estimated);
  else
    piece_ = Piece{odometry, estimated};
  if (!is_complete_(*piece_)) return;
  contradictory_.reset();
  if (is_contradictory_(*piece_)) contradictory_ = piece_;
  piece_.reset();
  in_a_row_ = contradictory_ ? in_a_row_ + 1 : 0;
  agreeing_ = contradictory_ ? 0 : agreeing_ + 1;
  is_evident_ = (is_evident_ || in_a_row_ >= kEvident) && agreeing_ < kOver;
}

void WayContradiction::add(const Motion& odometry, const Pose2& estimated) {
  if (since_) since_->add(odometry, estimated);
  ways_.add(odometry, estimated);
  turns_.add(odometry, estimated);
  const auto& of_way = ways_.contradictory();
  const auto& begun = of_way ? of_way : turns_.contradictory();
  if (!begun && !isEvident()) since_.reset();
  if (begun && !since_) since_ = begun;
}

WayContradiction::Distance WayContradiction::apart() const {
  if (!isEvident() || !since_) return {};
  const Pose2 between = since_->estimated.between(since_->odometry.increment);
  const auto& Q = since_->odometry.covariance;
  return {std::sqrt(between.position().squaredNorm() + Q(0, 0) + Q(1, 1)),
          std::hypot(between.theta(), std::sqrt(Q(2, 2)))};
}

}  // namespace slam
