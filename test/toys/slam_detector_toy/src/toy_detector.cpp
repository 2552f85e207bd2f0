// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "toy_detector.hpp"

#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam_toy {
namespace {

const slam::Registrar<slam::LandmarkDetector, ToyDetector> kRegistrar("toy");
const slam::SectionRegistrar<ToyDetectorConfig> kSectionRegistrar;

}  // namespace

void ToyDetectorConfig::describe(slam::Fields& fields) {
  fields.add("jump", &jump, "an edge is nearer than what stands behind it by at least this")
      .unit("m")
      .in(slam::Range::above(0));
  fields.add("sigma_range", &sigma_range, "standard deviation of an edge's range")
      .unit("m")
      .in(slam::Range::above(0));
  fields.add("sigma_bearing", &sigma_bearing, "standard deviation of an edge's bearing")
      .unit("rad")
      .in(slam::Range::above(0));
}

void ToyDetector::configure(slam::Settings& settings) {
  config_ = settings.read<ToyDetectorConfig>();
  reset();
}

void ToyDetector::describe(slam::Ports& ports) {
  ports.takes<slam::LaserScan>("scan", "laser scans", this);
  ports.makes<slam::LandmarkObservationArray>("observations", array_);
}

void ToyDetector::reset() {
  scan_.reset();
  last_.reset();
  array_.reset();
  sequence_ = 0;
  counters_.clear();
}

slam::Status ToyDetector::execute() {
  array_.reset();
  const auto scan = std::exchange(scan_, std::nullopt);
  if (!scan) return slam::Status::ok();
  if (last_ && scan->stamp <= *last_) {
    counters_.add("late");
    return slam::Status::warning("a scan that is not newer than the last is left out");
  }
  last_ = scan->stamp;
  find(*scan);
  return slam::Status::ok();
}

void ToyDetector::find(const slam::LaserScan& scan) {
  array_ = slam::LandmarkObservationArray{
      sequence_++, scan.stamp, scan.sensor_frame, scan.sensor_pose, {}};
  Eigen::Matrix2d R = Eigen::Matrix2d::Zero();
  R.diagonal() << config_.sigma_range * config_.sigma_range,
      config_.sigma_bearing * config_.sigma_bearing;
  for (std::size_t i = 1; i + 1 < scan.beams.size(); ++i) {
    const auto& beam = scan.beams[i];
    if (isEdge(beam, scan.beams[i - 1]) || isEdge(beam, scan.beams[i + 1]))
      array_->observations.push_back({slam::kUnknownId, beam.range, beam.bearing, R});
  }
}

/// A beam that met nothing tells nothing of what stands behind.
bool ToyDetector::isEdge(const slam::LaserBeam& beam, const slam::LaserBeam& other) const {
  return beam.hit && other.hit && beam.range > 0.0F &&
         static_cast<double>(other.range) - static_cast<double>(beam.range) > config_.jump;
}

}  // namespace slam_toy
