// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/constellation_evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/covariance.hpp"

// Symbols: T the pose of the robot in the map, l a landmark in the robot's frame, m one in the map,
// d = m - T l, S the covariance of d; H x = g the normal equations of a correction x of T.

namespace slam::association {
namespace {

constexpr double kMatchGate = 13.8;   // 0.999 of chi-square with two degrees of freedom
constexpr double kLeastSigma = 0.02;  // of what map and observations differ by in any case [m]

Eigen::Matrix2d covarianceOf(const Pose2& robot, const LocalLandmark& l, const Landmark& m) {
  const Eigen::Matrix2d R = robot.rotation();
  return m.covariance + R * l.covariance * R.transpose() +
         kLeastSigma * kLeastSigma * Eigen::Matrix2d::Identity();
}

}  // namespace

ConstellationEvidence::ConstellationEvidence(const LandmarkMap& map, double outlier_share)
    : map_(map), outlier_share_(outlier_share) {
  constexpr double kMargin = 3.0;  // the robot may see the outermost ones from outside [m]
  Eigen::AlignedBox2d box;
  for (const auto& landmark : map) box.extend(landmark.position);
  const Eigen::Vector2d inner =
      map.empty() ? Eigen::Vector2d(0.0, 0.0) : Eigen::Vector2d(box.sizes());
  const Eigen::Vector2d edges = inner.array() + 2.0 * kMargin;
  area_ = edges.prod();
  radius_ = 0.5 * edges.norm();
}

bool ConstellationEvidence::isInMap(const LocalLandmark& local) const {
  return std::any_of(map_.begin(), map_.end(),
                     [&](const Landmark& landmark) { return mayHaveIdOf(local, landmark); });
}

/// Each landmark of the map is one around the robot at most: the nearest.
std::vector<ConstellationEvidence::Pairing> ConstellationEvidence::pairingsAt(
    const Pose2& robot, const std::vector<LocalLandmark>& around) const {
  std::vector<std::pair<double, Pairing>> near;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Eigen::Vector2d seen = robot.transform(around[i].position);
    const double trace = around[i].covariance.trace() + 2.0 * kLeastSigma * kLeastSigma;
    for (std::size_t j = 0; j < map_.size(); ++j) {
      const Eigen::Vector2d d = map_[j].position - seen;
      // most landmarks are far away, and a trace needs no rotation
      if (d.squaredNorm() > kMatchGate * (trace + map_[j].covariance.trace())) continue;
      if (!mayHaveIdOf(around[i], map_[j])) continue;
      const auto S = covarianceOf(robot, around[i], map_[j]);
      const double squared = d.dot(S.inverse() * d);
      if (squared < kMatchGate && mayBe(around[i], map_[j])) near.push_back({squared, {i, j}});
    }
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Pairing> pairings;
  for (const auto& [squared, pairing] : near) {
    const auto is_taken = [pairing = pairing](const Pairing& other) {
      return other.local == pairing.local || other.landmark == pairing.landmark;
    };
    if (std::none_of(pairings.begin(), pairings.end(), is_taken)) pairings.push_back(pairing);
  }
  return pairings;
}

ConstellationEvidence::Normal ConstellationEvidence::equationsAt(
    const Pose2& robot, const std::vector<LocalLandmark>& around,
    const std::vector<Pairing>& pairings) const {
  Normal normal;
  for (const auto& [local, landmark] : pairings) {
    Eigen::Matrix<double, 2, 3> J;
    const Eigen::Vector2d d = map_[landmark].position - robot.transform(around[local].position, &J);
    const Eigen::Matrix2d W = covarianceOf(robot, around[local], map_[landmark]).inverse();
    normal.H += J.transpose() * W * J;
    normal.g += J.transpose() * W * d;
  }
  return normal;
}

/// What is seen of a landmark, relative to a landmark that may be anywhere in the map's area. Of
/// one without an id nothing is known but that it is some landmark of the map. One with an id of
/// the map that is elsewhere is an outlier; that it has this id is one for who is not in the map,
/// too.
double ConstellationEvidence::logOddsOf(const Pose2& robot, const LocalLandmark& local,
                                        const Landmark* landmark) const {
  const bool has_id = local.id != kUnknownId;
  const double of_outlier = has_id ? 1.0 : outlier_share_;
  if (landmark == nullptr) return std::log(of_outlier);
  const Eigen::Vector2d d = landmark->position - robot.transform(local.position);
  const auto S = covarianceOf(robot, local, *landmark);
  const double density =
      std::exp(-0.5 * d.dot(S.inverse() * d)) / (2.0 * M_PI * std::sqrt(S.determinant()));
  const double share = has_id ? (1.0 - outlier_share_) / outlier_share_
                              : (1.0 - outlier_share_) / static_cast<double>(map_.size());
  return std::log(of_outlier + share * area_ * density);
}

double ConstellationEvidence::logOddsOfOneAlone(const std::vector<LocalLandmark>& around) const {
  const auto named = std::count_if(around.begin(), around.end(), [this](const auto& local) {
    return local.id != kUnknownId && isInMap(local);
  });
  if (named == 0) return 0.0;
  return std::log(static_cast<double>(named) * (1.0 - outlier_share_) / outlier_share_);
}

double ConstellationEvidence::logOddsAt(const Pose2& robot,
                                        const std::vector<LocalLandmark>& around,
                                        const std::vector<Pairing>& pairings) const {
  std::vector<const Landmark*> matched(around.size(), nullptr);
  for (const auto& [local, landmark] : pairings) matched[local] = &map_[landmark];
  double sum = 0.0;
  for (std::size_t i = 0; i < around.size(); ++i)
    if (isInMap(around[i])) sum += logOddsOf(robot, around[i], matched[i]);
  return sum;
}

/// A landmark within reach may be hidden, and what hides it hides others.
double ConstellationEvidence::logOddsOfMissing(const Pose2& robot,
                                               const std::vector<Pairing>& pairings,
                                               const SensorReach& reach) const {
  constexpr double kHidden = 0.5;
  constexpr std::ptrdiff_t kMostMissing = 6;
  std::vector<char> is_seen(map_.size(), 0);
  for (const auto& pairing : pairings) is_seen[pairing.landmark] = 1;
  const Pose2 T_base_map = robot.inverse();
  std::ptrdiff_t missing = 0;
  for (std::size_t i = 0; i < map_.size(); ++i)
    missing += !is_seen[i] && reach.covers(T_base_map.transform(map_[i].position)) ? 1 : 0;
  return static_cast<double>(std::min(missing, kMostMissing)) * std::log(kHidden);
}

std::size_t ConstellationEvidence::within(const SensorReach& reach, const Pose2& robot) const {
  const Pose2 T_base_map = robot.inverse();
  return static_cast<std::size_t>(
      std::count_if(map_.begin(), map_.end(), [&](const Landmark& landmark) {
        return reach.covers(T_base_map.transform(landmark.position));
      }));
}

std::optional<Place> ConstellationEvidence::near(Pose2 robot,
                                                 const std::vector<LocalLandmark>& around,
                                                 const SensorReach& reach) const {
  constexpr int kSteps = 3;
  for (int step = 0; step < kSteps; ++step) {
    const auto pairings = pairingsAt(robot, around);
    if (pairings.size() < 2) return std::nullopt;
    const auto [H, g] = equationsAt(robot, around, pairings);
    robot = Pose2::fromVector(robot.vector() + H.ldlt().solve(g));
    if (!robot.isFinite()) return std::nullopt;
  }
  const auto pairings = pairingsAt(robot, around);
  if (pairings.size() < 2) return std::nullopt;
  const auto H = equationsAt(robot, around, pairings).H;
  Place place{{robot, symmetric(H.inverse())}, 0.0, pairings.size()};
  const double volume = std::pow(2.0 * M_PI, 1.5) / std::sqrt(H.determinant());
  place.log_odds = logOddsAt(robot, around, pairings) + logOddsOfMissing(robot, pairings, reach) +
                   std::log(volume / (area_ * 2.0 * M_PI));
  if (!std::isfinite(place.log_odds)) return std::nullopt;
  return place;
}

}  // namespace slam::association
