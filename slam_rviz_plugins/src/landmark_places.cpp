// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "landmark_places.hpp"

#include <algorithm>

namespace slam_rviz_plugins {
namespace {

double distanceTo(const QLineF& line, const QPointF& point) {
  const QPointF along = line.p2() - line.p1();
  const double length_squared = QPointF::dotProduct(along, along);
  if (length_squared == 0.0) return QLineF(line.p1(), point).length();
  const double foot = QPointF::dotProduct(point - line.p1(), along) / length_squared;
  return QLineF(line.pointAt(std::clamp(foot, 0.0, 1.0)), point).length();
}

}  // namespace

std::optional<std::size_t> nearestTo(const QPointF& mouse, const std::vector<LandmarkPlace>& places,
                                     double reach) {
  std::optional<std::size_t> nearest;
  double shortest = reach;
  for (const auto& place : places) {
    const double distance = distanceTo(place.line, mouse);
    if (distance > shortest || (nearest && distance == shortest)) continue;
    nearest = place.index;
    shortest = distance;
  }
  return nearest;
}

}  // namespace slam_rviz_plugins
