// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/point_search.hpp"

#include <cmath>
#include <optional>

#include "slam_core/mono_graph/orb_extractor.hpp"

namespace slam::mono_graph {
namespace {

constexpr double kLeastCosine = 0.6;   // between two views of a point
constexpr double kLevelsBeyond = 0.5;  // of the pyramid, at either end

bool looksAlike(const Feature& feature, const MapPoint& point, double level) {
  return std::abs(feature.level - level) <= 1.6 &&
         turnBetween(feature.angle, point.angle) <= kLargestRoll;
}

}  // namespace

std::optional<Appearance> appearanceOf(const VisualMap& map, const MapPoint& point,
                                       const Features& features, const Pose2& pose) {
  const auto seen = features.camera().project(pose, point.position);
  if (!seen || !features.covers(*seen)) return std::nullopt;
  const auto& host = map.keyframe(point.host());
  const Eigen::Vector3d now = point.position - features.camera().centre(pose);
  const Eigen::Vector3d then = point.position - host.features.camera().centre(host.pose);
  if (now.dot(then) < kLeastCosine * now.norm() * then.norm()) return std::nullopt;
  const double level =
      std::log(point.size * features.focal() / now.norm()) / std::log(kPyramidScale);
  if (level < -kLevelsBeyond || level > kPyramidLevels - 1 + kLevelsBeyond) return std::nullopt;
  return Appearance{*seen, level};
}

PointMatches searchPoints(const VisualMap& map, const std::vector<int>& points,
                          const Features& features, const Pose2& pose, const SearchLimits& limits) {
  PointMatches result;
  std::vector<int> distance_of(features.size(), 257);  // of the point that has a feature
  std::vector<int> owner(features.size(), kNoPoint);
  std::vector<std::size_t> near;
  for (const int number : points) {
    const auto& point = map.point(number);
    const auto appearance = appearanceOf(map, point, features, pose);
    if (!appearance) continue;
    result.expected.push_back(number);
    near.clear();
    features.near(appearance->seen, limits.radius, near);
    BestMatch best;
    for (const std::size_t i : near)
      if (looksAlike(features[i], point, appearance->level))
        best.consider(i, distanceOf(features[i].descriptor, point.descriptor));
    if (!best.isClear(limits.largest_distance, limits.ratio)) continue;
    if (best.distance >= distance_of[best.candidate]) continue;
    distance_of[best.candidate] = best.distance;
    owner[best.candidate] = number;
  }
  for (std::size_t i = 0; i < owner.size(); ++i)
    if (owner[i] != kNoPoint) result.matches.push_back({owner[i], i});
  return result;
}

}  // namespace slam::mono_graph
