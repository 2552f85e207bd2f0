// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/world.hpp"

#include <algorithm>
#include <cmath>

namespace slam::sim {

const std::vector<std::string>& ceilingTextures() {
  static const std::vector<std::string> kNames = {"tiles", "plaster", "plain"};
  return kNames;
}

const std::vector<std::string>& wallTextures() {
  static const std::vector<std::string> kNames = {"paint",     "plaster", "wallpaper", "brick",
                                                  "panelling", "posters", "mural"};
  return kNames;
}

const std::vector<std::string>& floorTextures() {
  static const std::vector<std::string> kNames = {"linoleum", "tiles", "parquet", "terrazzo"};
  return kNames;
}

const std::vector<std::string>& furnitureTextures() {
  static const std::vector<std::string> kNames = {"wood", "books", "panelling"};
  return kNames;
}

double Light::levelAt(double time) const {
  if (course.empty()) return 1.0;
  const auto after = std::find_if(course.begin(), course.end(),
                                  [time](const auto& point) { return point.x() > time; });
  if (after == course.begin()) return course.front().y();
  if (after == course.end()) return course.back().y();
  const auto& before = *(after - 1);
  const double part = (time - before.x()) / (after->x() - before.x());
  return before.y() + part * (after->y() - before.y());
}

Eigen::Isometry3d uprightMarker(const Eigen::Vector3d& position, double facing) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = position;
  T.linear().col(0) = Eigen::Vector3d(-std::sin(facing), std::cos(facing), 0.0);
  T.linear().col(1) = Eigen::Vector3d::UnitZ();
  T.linear().col(2) = Eigen::Vector3d(std::cos(facing), std::sin(facing), 0.0);
  return T;
}

}  // namespace slam::sim
