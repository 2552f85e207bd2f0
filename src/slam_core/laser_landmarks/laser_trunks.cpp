// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_trunks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::laser_landmarks {
namespace {

const Registrar<LandmarkDetector, LaserTrunks> kRegistrar("laser_trunks");
const SectionRegistrar<LaserTrunksConfig> kSectionRegistrar;

/// The number of beams gives a rough diameter. No circle is fitted where that is beyond the limits
/// by more than this factor.
constexpr double kRoughly = 1.5;
/// A filter takes the errors of scans for independent. Two errors of trunks of few beams, which are
/// the far ones, are not: one that is narrower than a beam looks as wide as one whenever it is
/// seen, and its axis half of that too far; and edges that lie between two beams ahead of a robot
/// stay there for many scans. These are their shares of the spacing for one beam, as standard
/// deviations. The radius errs with the range.
constexpr double kAlikeRange = 0.5, kAlikeBearing = 0.3;

Eigen::Matrix2d alikeBetweenScans(double range, double spacing, std::size_t beams) {
  const Eigen::Array2d sigmas(kAlikeRange * range * spacing, kAlikeBearing * spacing);
  return (sigmas.square() / static_cast<double>(beams)).matrix().asDiagonal();
}

double nearestOf(const ScanSegment& segment) {
  double nearest = segment.beams.front().range;
  for (const auto& beam : segment.beams) nearest = std::min<double>(nearest, beam.range);
  return nearest;
}

}  // namespace

void LaserTrunks::configure(const LaserTrunksConfig& config) {
  validate(config);
  if (config.min_diameter >= config.max_diameter)
    throw ConfigError("laser_trunks.min_diameter has to be less than laser_trunks.max_diameter");
  config_ = config;
  reset();
}

void LaserTrunks::configure(Settings& settings) { configure(settings.read<LaserTrunksConfig>()); }

Status LaserTrunks::find(const LaserScan& scan, Observations& found, Counters& counters) {
  const BeamNoise noise{config_.sigma_range, scan.relative_sigma, config_.sigma_bearing};
  const auto [segments, spacing] = segmentsOf(scan.beams, config_.max_jump, scan.relative_sigma);
  for (const auto& segment : segments) {
    if (nearestOf(segment) > config_.max_range) continue;
    const auto trunk = trunkOf(segment, spacing, noise, counters);
    if (!trunk) continue;
    const auto alike = alikeBetweenScans(trunk->range, spacing, segment.beams.size());
    found.push_back({kUnknownId, trunk->range, trunk->bearing, trunk->covariance + alike});
    found.back().descriptor =
        descriptorOf(trunk->radius, std::hypot(trunk->sigma_radius, std::sqrt(alike(0, 0))));
  }
  return Status::ok();
}

std::optional<Cylinder> LaserTrunks::trunkOf(const ScanSegment& segment, double spacing,
                                             const BeamNoise& noise, Counters& counters) const {
  auto rejection = rejectionOf(segment, spacing);
  std::optional<Cylinder> trunk;
  if (rejection.empty()) {
    trunk = fitCylinder(segment.beams, spacing, noise);
    rejection = rejectionOf(trunk);
  }
  if (rejection.empty()) return trunk;
  counters.add(rejection);
  return std::nullopt;
}

std::string LaserTrunks::rejectionOf(const ScanSegment& segment, double spacing) const {
  if (segment.beams.size() < static_cast<std::size_t>(config_.min_points)) return "few_points";
  if (segment.at_first == Beside::kNearer || segment.at_last == Beside::kNearer) return "hidden";
  if (segment.at_first == Beside::kUnknown || segment.at_last == Beside::kUnknown) return "cut_off";
  const double diameter = 2.0 * cylinderOfWidth(segment.beams, spacing).radius;
  if (diameter < config_.min_diameter / kRoughly) return "too_thin";
  if (diameter > config_.max_diameter * kRoughly) return "too_thick";
  return "";
}

std::string LaserTrunks::rejectionOf(const std::optional<Cylinder>& trunk) const {
  if (!trunk || trunk->misfit > config_.max_misfit) return "no_circle";
  if (2.0 * trunk->radius < config_.min_diameter) return "too_thin";
  if (2.0 * trunk->radius > config_.max_diameter) return "too_thick";
  return "";
}

}  // namespace slam::laser_landmarks
