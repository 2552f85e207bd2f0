// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_lines.hpp"

#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/laser_landmarks/observation_array.hpp"

namespace slam::laser_landmarks {
namespace {

const Registrar<LandmarkDetector, LaserLines> kLinesRegistrar("laser_lines");
const Registrar<LandmarkDetector, LaserCorners> kCornersRegistrar("laser_corners");
const SectionRegistrar<LaserLinesConfig> kLinesSectionRegistrar;

}  // namespace

void WallDetector::configure(const LaserLinesConfig& config) {
  validate(config);
  config_ = config;
  reset();
}

void WallDetector::configure(Settings& settings) { configure(settings.read<LaserLinesConfig>()); }

void WallDetector::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", this);
  ports.makes<LandmarkObservationArray>("observations", observations_);
}

void WallDetector::reset() {
  next_scan_.reset();
  observations_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status WallDetector::execute() {
  observations_.reset();
  const auto scan = std::exchange(next_scan_, std::nullopt);
  if (!scan) return Status::ok();
  observations_ = emptyArray(*scan, next_sequence_++);
  for (const auto& z : landmarksOf(wallLinesOf(*scan, config_, counters_)))
    if (faultOf(z).empty()) observations_->observations.push_back(z);
  return Status::ok();
}

std::vector<LandmarkObservation> LaserLines::landmarksOf(const std::vector<WallLine>& lines) const {
  std::vector<LandmarkObservation> landmarks;
  for (const auto& wall : wallsOf(lines, config().sigma_wall))
    landmarks.push_back(
        {kUnknownId, wall.range, wall.bearing, wall.covariance, LandmarkKind::kLine, wall.extent});
  return landmarks;
}

std::vector<LandmarkObservation> LaserCorners::landmarksOf(
    const std::vector<WallLine>& lines) const {
  std::vector<LandmarkObservation> landmarks;
  for (const auto& [position, covariance] : cornersOf(lines, config()))
    landmarks.push_back(observationOf(position, covariance));
  return landmarks;
}

}  // namespace slam::laser_landmarks
