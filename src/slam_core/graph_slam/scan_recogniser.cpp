// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_recogniser.hpp"

namespace slam::graph_slam {

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
  const auto points = scan_matching::pointsOf(scan, models_, spacing_);
  return matcher_.recogniseAnywhere(map_.view(), points, places_);
}

}  // namespace slam::graph_slam
