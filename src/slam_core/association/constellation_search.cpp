// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/constellation_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "slam_core/geometry/one_place.hpp"

namespace slam::association {
namespace {

constexpr double kBaseline = 0.25;  // two landmarks that tell a heading are so far apart [m]
constexpr double kWidest = 40.0;    // and no further, as one sensor sees them [m]
/// Landmarks around the robot of which all pairs suggest poses: the surest ones.
constexpr std::size_t kMostPaired = 12;
/// Poses within one cell are counted as the same suggestion.
constexpr double kCell = 0.5, kCellAngle = 0.3;  // [m], [rad]
constexpr std::size_t kMostWeighed = 100, kMostPlaces = 8;

/// The transform that takes the midpoint of a and b to that of a_map and b_map, and the direction
/// from a to b to that from a_map to b_map.
Pose2 aligned(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& a_map,
              const Eigen::Vector2d& b_map) {
  const Eigen::Vector2d d = b - a, d_map = b_map - a_map;
  const Pose2 turn(0.0, 0.0, std::atan2(d_map.y(), d_map.x()) - std::atan2(d.y(), d.x()));
  const Eigen::Vector2d shift = 0.5 * (a_map + b_map) - turn.transform(0.5 * (a + b));
  return {shift.x(), shift.y(), turn.theta()};
}

std::vector<LocalLandmark> surest(std::vector<LocalLandmark> around, std::size_t most) {
  std::stable_sort(around.begin(), around.end(), [](const auto& a, const auto& b) {
    return a.covariance.trace() < b.covariance.trace();
  });
  if (around.size() > most) around.resize(most);
  return around;
}

/// The mean of the poses in each cell, the cells with most poses first.
std::vector<Pose2> mostSuggested(const std::vector<Pose2>& poses) {
  struct Votes {
    int count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  };
  std::map<std::array<long, 3>, Votes> cells;
  for (const auto& pose : poses) {
    auto& votes = cells[{std::lround(pose.x() / kCell), std::lround(pose.y() / kCell),
                         std::lround(pose.theta() / kCellAngle)}];
    ++votes.count;
    votes.sum += pose.vector();
  }
  std::vector<Votes> counted;
  for (const auto& [cell, votes] : cells) counted.push_back(votes);
  std::stable_sort(counted.begin(), counted.end(),
                   [](const Votes& a, const Votes& b) { return a.count > b.count; });
  if (counted.size() > kMostWeighed) counted.resize(kMostWeighed);
  std::vector<Pose2> most;
  for (const auto& [count, sum] : counted) most.push_back(Pose2::fromVector(sum / count));
  return most;
}

}  // namespace

ConstellationSearch::ConstellationSearch(const LandmarkMap& map, double outlier_share)
    : map_(map), evidence_(map, outlier_share) {
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = i + 1; j < map.size(); ++j) {
      const double distance = (map[i].position - map[j].position).norm();
      if (distance > kBaseline && distance < kWidest) pairs_.push_back({distance, i, j});
    }
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const MapPair& a, const MapPair& b) { return a.distance < b.distance; });
}

void ConstellationSearch::suggest(const LocalLandmark& a, const LocalLandmark& b,
                                  std::vector<Pose2>& poses) const {
  constexpr double kSigmas = 3.5, kOfMap = 0.1;  // [1], [m]
  const double distance = (b.position - a.position).norm();
  if (distance < kBaseline) return;
  const double margin = kOfMap + kSigmas * std::sqrt(a.covariance.trace() + b.covariance.trace());
  const auto is_below = [](const MapPair& pair, double limit) { return pair.distance < limit; };
  auto pair = std::lower_bound(pairs_.begin(), pairs_.end(), distance - margin, is_below);
  for (; pair != pairs_.end() && pair->distance < distance + margin; ++pair)
    for (const auto& [i, j] :
         {std::pair(pair->first, pair->second), std::pair(pair->second, pair->first)})
      if (ConstellationEvidence::mayBe(a, map_[i]) && ConstellationEvidence::mayBe(b, map_[j]))
        poses.push_back(aligned(a.position, b.position, map_[i].position, map_[j].position));
}

std::vector<Pose2> ConstellationSearch::suggestions(
    const std::vector<LocalLandmark>& around) const {
  const auto paired = surest(around, kMostPaired);
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < paired.size(); ++i)
    for (std::size_t j = i + 1; j < paired.size(); ++j) suggest(paired[i], paired[j], poses);
  return mostSuggested(poses);
}

std::vector<Place> ConstellationSearch::placesOf(const std::vector<LocalLandmark>& around,
                                                 const SensorReach& reach) const {
  std::vector<Place> places;
  for (const auto& robot : suggestions(around))
    if (const auto place = evidence_.near(robot, around, reach)) places.push_back(*place);
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.log_odds > b.log_odds; });
  std::vector<Place> apart;
  for (const auto& place : places) {
    const auto is_same = [&](const Place& other) {
      return areOnePlace(other.robot.pose, place.robot.pose);
    };
    if (apart.size() < kMostPlaces && std::none_of(apart.begin(), apart.end(), is_same))
      apart.push_back(place);
  }
  return apart;
}

}  // namespace slam::association
