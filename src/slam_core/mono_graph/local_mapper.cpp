// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/local_mapper.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "slam_core/mono_graph/point_search.hpp"
#include "slam_core/mono_graph/triangulation.hpp"

namespace slam::mono_graph {
namespace {

constexpr std::size_t kTriangulated = 4;  // neighbours that new points come from
constexpr int kTrial = 2;                 // keyframes after which a point has proved itself
constexpr double kLeastFound = 0.25;      // share of the images that were to show it
constexpr double kJoinRadius = 4.0;       // [px]
constexpr int kAdjustmentSteps = 6;       // of an adjustment
constexpr std::size_t kMostFixed = 12;    // keyframes beyond the window
constexpr double kKeptChi2 = 9.0;         // chi2 of a sighting that is kept

/// A part of the map as a bundle, and where its parts come from.
class Neighbourhood {
 public:
  Neighbourhood(const VisualMap& map, const std::vector<int>& keyframes) : keyframes_(keyframes) {
    std::sort(keyframes_.begin(), keyframes_.end());
    const std::size_t moving = keyframes_.size();
    points_ = pointsSeenBy(map, keyframes_);
    addFixed(map);
    for (std::size_t i = 0; i < keyframes_.size(); ++i) {
      const auto& keyframe = map.keyframe(keyframes_[i]);
      const bool is_origin = i == 0 && (keyframes_[i] == 0 || keyframes_.size() == moving);
      const bool is_fixed = i >= moving || is_origin;
      bundle_.views.push_back({keyframe.pose, keyframe.features.camera(), is_fixed});
      view_of_[keyframes_[i]] = static_cast<int>(i);
    }
    for (const int point : points_) addPoint(map, point);
    for (const int keyframe : keyframes_) addWay(map, keyframe);
  }

  Bundle& bundle() { return bundle_; }

  void writeTo(VisualMap& map) const {
    for (std::size_t i = 0; i < keyframes_.size(); ++i)
      map.keyframe(keyframes_[i]).pose = bundle_.views[i].pose;
    for (std::size_t i = 0; i < points_.size(); ++i)
      map.point(points_[i]).position = bundle_.points[i];
    for (const auto& observation : bundle_.observations) {
      const int point = points_[static_cast<std::size_t>(observation.point)];
      if (!map.point(point).isGone() && chi2Of(bundle_, observation) > kKeptChi2)
        map.removeSighting(point, keyframes_[static_cast<std::size_t>(observation.view)]);
    }
  }

 private:
  /// Keyframes that see the points as well hold the neighbourhood in its place.
  void addFixed(const VisualMap& map) {
    std::map<int, int> seen;
    for (const int point : points_)
      for (const auto& sighting : map.point(point).sightings) ++seen[sighting.keyframe];
    for (const int keyframe : keyframes_) seen.erase(keyframe);
    std::vector<std::pair<int, int>> ranked;
    for (const auto& [keyframe, count] : seen) ranked.emplace_back(-count, keyframe);
    std::sort(ranked.begin(), ranked.end());
    if (ranked.size() > kMostFixed) ranked.resize(kMostFixed);
    for (const auto& each : ranked) keyframes_.push_back(each.second);
  }

  void addPoint(const VisualMap& map, int number) {
    const int index = static_cast<int>(bundle_.points.size());
    bundle_.points.push_back(map.point(number).position);
    for (const auto& sighting : map.point(number).sightings) {
      const auto view = view_of_.find(sighting.keyframe);
      if (view == view_of_.end()) continue;
      const auto& feature =
          map.keyframe(sighting.keyframe).features[static_cast<std::size_t>(sighting.feature)];
      bundle_.observations.push_back({view->second, index, feature.seen, feature.sigma});
    }
  }

  void addWay(const VisualMap& map, int number) {
    const auto from = view_of_.find(number - 1), to = view_of_.find(number);
    const auto& keyframe = map.keyframe(number);
    if (from == view_of_.end() || !keyframe.way) return;
    bundle_.ways.push_back({from->second, to->second, *keyframe.way, keyframe.way_covariance});
  }

  std::vector<int> keyframes_;  ///< by view; those that move first
  std::vector<int> points_;     ///< by point of the bundle
  std::map<int, int> view_of_;
  Bundle bundle_;
};

void mergeIntoBetterKnown(VisualMap& map, int a, int b) {
  const bool is_first = map.point(a).sightings.size() > map.point(b).sightings.size();
  map.merge(is_first ? a : b, is_first ? b : a);
}

}  // namespace

void joinPoints(VisualMap& map, const std::vector<int>& points, const std::vector<int>& keyframes) {
  SearchLimits limits;
  limits.radius = kJoinRadius;
  for (const int number : keyframes) {
    std::vector<int> unseen;
    for (const int point : points)
      if (!map.point(point).isGone()) unseen.push_back(point);
    const auto& keyframe = map.keyframe(number);
    const auto found = searchPoints(map, unseen, keyframe.features, keyframe.pose, limits);
    for (const auto& match : found.matches) {
      const int other = map.keyframe(number).points[match.feature];
      if (other == kNoPoint)
        map.addSighting(match.point, {number, static_cast<int>(match.feature)});
      else if (other != match.point && !map.point(match.point).isGone())
        mergeIntoBetterKnown(map, match.point, other);
    }
  }
}

void adjustAround(VisualMap& map, int keyframe, int window) {
  auto keyframes = neighboursOf(map, keyframe, static_cast<std::size_t>(window - 1));
  keyframes.push_back(keyframe);
  Neighbourhood neighbourhood(map, keyframes);
  adjust(neighbourhood.bundle(), kAdjustmentSteps);
  neighbourhood.writeTo(map);
}

void LocalMapper::map(VisualMap& map) {
  const int newest = static_cast<int>(map.keyframes().size()) - 1;
  cull(map, newest);
  addPoints(map, newest);
}

void LocalMapper::cull(VisualMap& map, int newest) {
  std::vector<Recent> still;
  for (const auto& each : recent_) {
    const auto& point = map.point(each.point);
    if (point.isGone() || point.host() != each.host) continue;
    if (point.found < kLeastFound * point.expected)
      map.remove(each.point);
    else if (newest - each.host < kTrial)
      still.push_back(each);
  }
  recent_ = std::move(still);
}

void LocalMapper::addPoints(VisualMap& map, int newest) {
  auto neighbours = neighboursOf(map, newest, kTriangulated);
  for (const int before : {newest - 1, newest - 2})
    if (before >= 0 && std::find(neighbours.begin(), neighbours.end(), before) == neighbours.end())
      neighbours.push_back(before);
  std::vector<int> made;
  for (const int neighbour : neighbours)
    for (auto& point : triangulate(map, newest, neighbour)) {
      made.push_back(map.add(std::move(point)));
      recent_.push_back({made.back(), newest});
    }
  joinPoints(map, made, neighbours);
}

}  // namespace slam::mono_graph
