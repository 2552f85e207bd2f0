// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/common/sorted_unique.hpp"

namespace slam::seif {
namespace {

/// Returns the size of the smallest cells [m]. It is a power of two, so that cells of different
/// radii have common borders.
double leastCell(double radius) {
  constexpr double kShare = 0.25;  // of the radius, so that the innermost shell is thin
  return kShare * std::exp2(std::ceil(std::log2(radius)));
}

/// Doubles the size of the cells of a square grid until two points lie in the same cell or in
/// neighbouring ones. @return how often
int doublingsUntilNeighbours(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double cell) {
  constexpr int kMost = 40;
  const auto cellOf = [](const Eigen::Vector2d& point, double size) {
    return Eigen::Vector2d((point / size).array().floor());
  };
  int doublings = 0;
  for (; doublings < kMost; ++doublings, cell *= 2.0)
    if ((cellOf(a, cell) - cellOf(b, cell)).cwiseAbs().maxCoeff() <= 1.0) break;
  return doublings;
}

}  // namespace

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
  vicinity.shell = [&graph, near, robot, least = leastCell(radius_)](graph::Key key) {
    if (std::binary_search(near.begin(), near.end(), key)) return 0;
    return 1 + doublingsUntilNeighbours(graph.pose(key).position(), robot, least);
  };
  return vicinity;
}

}  // namespace slam::seif
