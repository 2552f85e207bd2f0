// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/visual_map.hpp"

#include <algorithm>
#include <utility>

#include "slam_core/common/sorted_unique.hpp"

namespace slam::mono_graph {
namespace {

Eigen::Vector3d moved(const Pose2& by, const Eigen::Vector3d& point) {
  const Eigen::Vector2d on_floor = by.transform(point.head<2>());
  return {on_floor.x(), on_floor.y(), point.z()};
}

}  // namespace

int VisualMap::add(Keyframe keyframe) {
  keyframe.points.resize(keyframe.features.size(), kNoPoint);
  keyframes_.push_back(std::move(keyframe));
  return static_cast<int>(keyframes_.size()) - 1;
}

int VisualMap::add(MapPoint point) {
  int place = static_cast<int>(points_.size());
  if (free_.empty()) {
    points_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  for (const auto& sighting : point.sightings)
    keyframe(sighting.keyframe).points[static_cast<std::size_t>(sighting.feature)] = place;
  this->point(place) = std::move(point);
  return place;
}

bool VisualMap::addSighting(int point, Sighting sighting) {
  if (this->point(point).isGone()) return false;
  auto& slot = keyframe(sighting.keyframe).points[static_cast<std::size_t>(sighting.feature)];
  auto& sightings = this->point(point).sightings;
  const bool is_known = std::any_of(sightings.begin(), sightings.end(), [&](const auto& each) {
    return each.keyframe == sighting.keyframe;
  });
  if (is_known || slot != kNoPoint) return false;
  slot = point;
  sightings.push_back(sighting);
  return true;
}

void VisualMap::removeSighting(int point, int keyframe) {
  auto& sightings = this->point(point).sightings;
  const auto found = std::find_if(sightings.begin(), sightings.end(),
                                  [&](const auto& each) { return each.keyframe == keyframe; });
  if (found == sightings.end()) return;
  if (sightings.size() <= 2) return remove(point);
  this->keyframe(keyframe).points[static_cast<std::size_t>(found->feature)] = kNoPoint;
  sightings.erase(found);
}

void VisualMap::remove(int point) {
  for (const auto& sighting : this->point(point).sightings)
    keyframe(sighting.keyframe).points[static_cast<std::size_t>(sighting.feature)] = kNoPoint;
  this->point(point) = MapPoint();
  free_.push_back(point);
}

void VisualMap::merge(int point, int other) {
  const auto sightings = this->point(other).sightings;
  const int expected = this->point(other).expected, found = this->point(other).found;
  remove(other);
  for (const auto& sighting : sightings) addSighting(point, sighting);
  this->point(point).expected += expected;
  this->point(point).found += found;
}

std::map<int, int> sharedPoints(const VisualMap& map, int keyframe) {
  std::map<int, int> shared;
  for (const int point : map.keyframe(keyframe).points) {
    if (point == kNoPoint) continue;
    for (const auto& sighting : map.point(point).sightings)
      if (sighting.keyframe != keyframe) ++shared[sighting.keyframe];
  }
  return shared;
}

std::vector<int> neighboursOf(const VisualMap& map, int keyframe, std::size_t most) {
  std::vector<std::pair<int, int>> ranked;  // by number of points, the newer one first
  for (const auto& [other, count] : sharedPoints(map, keyframe))
    if (count >= kNeighbourPoints) ranked.emplace_back(count, other);
  std::sort(ranked.rbegin(), ranked.rend());
  if (ranked.size() > most) ranked.resize(most);
  std::vector<int> neighbours;
  for (const auto& each : ranked) neighbours.push_back(each.second);
  return neighbours;
}

std::vector<int> pointsSeenBy(const VisualMap& map, const std::vector<int>& keyframes) {
  std::vector<int> points;
  for (const int keyframe : keyframes)
    for (const int point : map.keyframe(keyframe).points)
      if (point != kNoPoint) points.push_back(point);
  return sortedUnique(std::move(points));
}

void moveKeyframes(VisualMap& map, const std::vector<Pose2>& poses) {
  std::vector<Pose2> corrections;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    auto& keyframe = map.keyframes()[i];
    corrections.push_back(poses[i] * keyframe.pose.inverse());
    keyframe.pose = poses[i];
  }
  for (auto& point : map.points())
    if (!point.isGone())
      point.position = moved(corrections[static_cast<std::size_t>(point.host())], point.position);
}

}  // namespace slam::mono_graph
