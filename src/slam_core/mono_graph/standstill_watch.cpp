// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/standstill_watch.hpp"

#include <cmath>

#include "slam_core/mono_graph/two_views.hpp"

namespace slam::mono_graph {
namespace {

/// A robot that has moved and turned by less stands [m], [rad].
constexpr double kWay = 0.002, kTurn = 0.004;
// A feature that is a metre away moves by so much on the plane z = 1 meanwhile.
constexpr double kStanding = kWay + kTurn;
// Features are searched for where this standard deviation of a turn may have moved them [rad].
constexpr double kSearchedTurn = 0.06;
constexpr std::size_t kMostWatched = 100;  ///< features, the strongest ones
constexpr std::size_t kFewestWatched = 20;
constexpr double kMovedSigmas = 4.0;  ///< a feature that has moved by more is elsewhere
/// Shares of the features, of an image of a robot that stands, and of one that has moved.
constexpr double kInPlace = 0.5, kLeft = 0.2, kElsewhereShare = 0.3;
constexpr int kMostMoved = 3;        ///< images in a row, then the robot is lost
constexpr int kMostUnconfirmed = 5;  ///< first images that give way to the next one

bool isStanding(const OdometryAnchor& odometry) {
  const Pose2 since = odometry.since().pose;
  return since.position().norm() <= kWay && std::abs(since.theta()) <= kTurn;
}

/// The shares of the features of an image that a later one shows in the same place and elsewhere;
/// nothing where there are too few.
struct Shares {
  double in_place = 0.0, elsewhere = 0.0;
};
std::optional<Shares> sharesOf(const Features& first, const Features& later) {
  PosePrior anywhere{Pose2(), Eigen::Matrix3d::Zero()};
  anywhere.covariance(2, 2) = kSearchedTurn * kSearchedTurn;
  const auto again = pairFeatures(first, later, anywhere, kMostWatched);
  if (again.expected < kFewestWatched) return std::nullopt;
  Shares shares;
  for (const auto& pair : again.pairs) {
    const auto& feature = first[pair.earlier];
    const bool has_moved =
        (later[pair.later].seen - feature.seen).norm() > kMovedSigmas * feature.sigma + kStanding;
    (has_moved ? shares.elsewhere : shares.in_place) += 1.0 / static_cast<double>(again.expected);
  }
  return shares;
}

}  // namespace

void StandstillWatch::move(const Motion& motion) { odometry_.move(motion); }

void StandstillWatch::judge(const Features& features, Stamp stamp) {
  if (!first_ || !isStanding(odometry_) || first_->focal() != features.focal()) {
    begin(features);
    unconfirmed_ = kMostUnconfirmed;
    return;
  }
  const auto shares = sharesOf(*first_, features);
  if (!shares) return;
  if (unconfirmed_ > 0) {
    unconfirmed_ = shares->in_place >= kInPlace ? 0 : unconfirmed_ - 1;
    if (unconfirmed_ > 0) begin(features);
    return;
  }
  const bool has_moved = shares->in_place < kLeft && shares->elsewhere >= kElsewhereShare;
  moved_ = has_moved ? moved_ + 1 : 0;
  if (moved_ == 1) moved_since_ = stamp;
  if (moved_ >= kMostMoved && !lost_since_) lost_since_ = moved_since_;
}

/// Later images are compared with this one.
void StandstillWatch::begin(const Features& features) {
  first_ = features;
  odometry_ = {};
  moved_ = 0;
}

}  // namespace slam::mono_graph
