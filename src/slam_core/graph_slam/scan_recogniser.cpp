// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_recogniser.hpp"

#include <cmath>

namespace slam::graph_slam {
namespace {

/// A robot is recognised from places so far beyond those where the map was made [m].
constexpr double kBeyond = 2.0;

}  // namespace

ScanRecogniser::ScanRecogniser(const grid_map::GridMapConfig& grid,
                               const scan_matching::MatcherConfig& matcher)
    : config_(grid),
      models_(scan_matching::levelModels(grid)),
      spacing_(matcher.spacing),
      matcher_(matcher),
      map_(grid) {}

void ScanRecogniser::draw(const LaserScan& scan, const Pose2& pose) {
  constexpr double kNoMatter = 1.0;  // ends to match with a map are not needed to draw one
  const auto points = scan_matching::pointsOf(scan, models_, kNoMatter);
  const double needed = static_cast<double>(map_.bytes()) + scan_matching::mostBytesFor(points);
  if (!grid_map::isWithinMemory(needed, config_)) return;
  map_.insert(points, pose);
  places_.extend(pose.position());
}

std::optional<scan_matching::Match> ScanRecogniser::find(const LaserScan& scan) const {
  if (map_.isEmpty()) return std::nullopt;
  const auto points = scan_matching::pointsOf(scan, models_, spacing_);
  const double reach = 0.5 * places_.sizes().maxCoeff() + kBeyond;
  const Pose2 middle(places_.center().x(), places_.center().y(), 0.0);
  const Eigen::Vector3d sigma(reach, reach, M_PI);
  const scan_matching::PosePrior anywhere{middle, sigma.cwiseAbs2().cwiseInverse().asDiagonal()};
  return matcher_.recognise(map_.view(), points, anywhere, {reach, M_PI});
}

}  // namespace slam::graph_slam
