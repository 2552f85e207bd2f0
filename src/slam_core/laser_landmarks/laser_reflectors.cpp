// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_reflectors.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/laser_landmarks/scan_segments.hpp"

namespace slam::laser_landmarks {
namespace {

const Registrar<LandmarkDetector, LaserReflectors> kReflectorsRegistrar("laser_reflectors");
const SectionRegistrar<LaserReflectorsConfig> kReflectorsSectionRegistrar;

constexpr int kPatience = 50;  // scans without intensities before a warning

double meanRange(const ScanSegment& reflector) {
  double sum = 0.0;
  for (const auto& beam : reflector.beams) sum += beam.range;
  return sum / static_cast<double>(reflector.beams.size());
}

double angularWidth(const ScanSegment& reflector, double spacing) {
  return reflector.beams.back().bearing - reflector.beams.front().bearing + spacing;
}

/// The distance of a cylinder's axis from the sensor [m] by the range of one beam.
/// @param angle between the beam and the direction of the axis [rad]; a beam that would miss the
/// cylinder counts as one that touches its edge
double rangeToAxis(double range, double angle, double radius) {
  const double sideways = range * std::sin(angle);
  return range * std::cos(angle) + std::sqrt(std::max(0.0, radius * radius - sideways * sideways));
}

}  // namespace

void LaserReflectors::configure(const LaserReflectorsConfig& config) {
  validate(config);
  if (config.min_width >= config.max_width)
    throw ConfigError("laser_reflectors.min_width has to be less than laser_reflectors.max_width");
  config_ = config;
  reset();
}

void LaserReflectors::configure(Settings& settings) {
  configure(settings.read<LaserReflectorsConfig>());
}

void LaserReflectors::reset() {
  ScanDetector::reset();
  dark_scans_ = 0;
}

Status LaserReflectors::find(const LaserScan& scan, Observations& found, Counters& counters) {
  const Brightness brightness(scan.beams, config_.range_exponent, config_.contrast);
  const BeamNoise noise{config_.sigma_range, scan.relative_sigma, config_.sigma_bearing};
  const auto [segments, spacing] = segmentsOf(scan.beams, config_.max_jump, scan.relative_sigma);
  for (const auto& segment : segments)
    for (const auto& part : brightness.brightPartsOf(segment)) {
      if (meanRange(part) > config_.max_range) continue;
      const auto rejection = rejectionOf(part, spacing);
      if (rejection.empty())
        found.push_back(landmarkOf(part, spacing, noise));
      else
        counters.add(rejection);
    }
  return watchIntensities(brightness.isKnown());
}

std::string LaserReflectors::rejectionOf(const ScanSegment& reflector, double spacing) const {
  if (reflector.at_first == Beside::kNearer || reflector.at_last == Beside::kNearer)
    return "hidden";
  if (reflector.at_first == Beside::kUnknown || reflector.at_last == Beside::kUnknown)
    return "cut_off";
  const double range = meanRange(reflector), width = range * angularWidth(reflector, spacing);
  if (width + range * spacing < config_.min_width) return "too_narrow";
  return width - range * spacing > config_.max_width ? "too_wide" : "";
}

/// The bearing is the middle between two edges.
LandmarkObservation LaserReflectors::landmarkOf(const ScanSegment& reflector, double spacing,
                                                const BeamNoise& noise) const {
  const auto& beams = reflector.beams;
  const double middle = (beams.front().bearing + beams.back().bearing) / 2.0;
  double sum = 0.0;
  for (const auto& beam : beams)
    sum += rangeToAxis(beam.range, beam.bearing - middle, config_.radius);
  const auto count = static_cast<double>(beams.size());
  LandmarkObservation z;
  z.range = sum / count;
  z.bearing = wrapAngle(middle);
  z.covariance = Eigen::Vector2d(noise.rangeVariance(z.range) / count,
                                 noise.edgeVariance(spacing) / std::min(count, 2.0))
                     .asDiagonal();
  return z;
}

Status LaserReflectors::watchIntensities(bool is_known) {
  if (is_known) dark_scans_ = -1;
  if (dark_scans_ < 0 || ++dark_scans_ < kPatience) return Status::ok();
  return Status::warning(
      "the laser has told no intensity yet, by which laser_reflectors finds reflectors: have its "
      "driver send intensities, or choose another detector");
}

}  // namespace slam::laser_landmarks
