// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/common/sorted_unique.hpp"

namespace slam::seif {

/// The landmarks of the local maps of what was observed that are nearest to the robot.
/// @return their variables
std::vector<graph::Key> Surroundings::gather(const std::vector<std::size_t>& observed,
                                             const Eigen::Vector2d& robot) {
  constexpr double kLeastRadius = 1.0;  // [m]
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (const auto landmark : maps_.around(observed))
    by_distance.emplace_back((landmarks_.point(landmark) - robot).norm(), landmark);
  std::sort(by_distance.begin(), by_distance.end());
  by_distance.resize(std::min(by_distance.size(), most_));
  radius_ = by_distance.empty() ? kLeastRadius : std::max(kLeastRadius, by_distance.back().first);
  near_ = observed;
  std::vector<graph::Key> gathered;
  for (const auto& [distance, landmark] : by_distance) {
    near_.push_back(landmark);
    gathered.push_back(keyOf(landmarks_, landmark));
  }
  near_ = sortedUnique(std::move(near_));
  return gathered;
}

graph::Vicinity Surroundings::follow(const std::vector<std::size_t>& observed) {
  graph::Vicinity vicinity;
  const auto node = path_.tail().node;
  if (!node) return vicinity;
  const auto& graph = path_.graph();
  const Eigen::Vector2d robot = graph.pose(*node).position();
  const auto is_elsewhere = [this](std::size_t landmark) {
    return !std::binary_search(near_.begin(), near_.end(), landmark) && maps_.knows(landmark);
  };
  if (std::any_of(observed.begin(), observed.end(), is_elsewhere))
    vicinity.gathered = gather(observed, robot);
  std::vector<graph::Key> near;
  for (const auto landmark : near_) near.push_back(keyOf(landmarks_, landmark));
  std::sort(near.begin(), near.end());
  vicinity.shell = [&graph, near, robot, radius = radius_](graph::Key key) {
    if (std::binary_search(near.begin(), near.end(), key)) return 0;
    const double distance = (graph.pose(key).position() - robot).norm();
    return 1 + static_cast<int>(std::log2(std::max(1.0, distance / radius)));
  };
  return vicinity;
}

}  // namespace slam::seif
