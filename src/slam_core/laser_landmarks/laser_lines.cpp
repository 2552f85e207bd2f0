// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_lines.hpp"

#include <cmath>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::laser_landmarks {
namespace {

const Registrar<LandmarkDetector, LaserLines> kLinesRegistrar("laser_lines");
const Registrar<LandmarkDetector, LaserCorners> kCornersRegistrar("laser_corners");
const SectionRegistrar<LaserLinesConfig> kLinesSectionRegistrar;

/// The observation of a point landmark without an id.
/// @param place in the sensor's frame [m] @param covariance of the place [m^2]
LandmarkObservation observationOf(const Eigen::Vector2d& place, const Eigen::Matrix2d& covariance) {
  const double range = place.norm();
  Eigen::Matrix2d J;
  J << place.x() / range, place.y() / range, -place.y() / (range * range),
      place.x() / (range * range);
  return {kUnknownId, range, std::atan2(place.y(), place.x()), J * covariance * J.transpose()};
}

}  // namespace

void WallDetector::configure(const LaserLinesConfig& config) {
  validate(config);
  config_ = config;
  reset();
}

void WallDetector::configure(Settings& settings) { configure(settings.read<LaserLinesConfig>()); }

Status WallDetector::find(const LaserScan& scan, Observations& found, Counters& counters) {
  found = landmarksOf(wallLinesOf(scan, config_, counters));
  return Status::ok();
}

ScanDetector::Observations LaserLines::landmarksOf(const std::vector<WallLine>& lines) const {
  Observations landmarks;
  for (const auto& wall : wallsOf(lines, config().sigma_wall))
    landmarks.push_back(
        {kUnknownId, wall.range, wall.bearing, wall.covariance, LandmarkKind::kLine, wall.extent});
  return landmarks;
}

ScanDetector::Observations LaserCorners::landmarksOf(const std::vector<WallLine>& lines) const {
  Observations landmarks;
  for (const auto& [position, covariance] : cornersOf(lines, config()))
    landmarks.push_back(observationOf(position, covariance));
  return landmarks;
}

}  // namespace slam::laser_landmarks
