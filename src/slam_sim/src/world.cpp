// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/world.hpp"

#include <cmath>

namespace slam::sim {

const std::vector<std::string>& ceilingTextures() {
  static const std::vector<std::string> kNames = {"tiles", "plaster", "plain"};
  return kNames;
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
