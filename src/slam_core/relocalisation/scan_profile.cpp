// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/scan_profile.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/angle.hpp"

namespace slam::relocalisation {
namespace {

constexpr double kHalfWindow = 0.045;  // in which a surface is looked for [rad]
constexpr double kTolerance = 0.2, kToleranceOfRange = 0.03;  // of a range [m], and relative to it
constexpr std::size_t kMostBeams = 400;                       // that are compared
constexpr std::size_t kFewestBeams = 20;
/// A scan is unlike if this share of its beams is. In real buildings scans a moment apart seldom
/// reach half of it, and most scans of other places exceed it.
constexpr double kUnlike = 0.35;
/// Each kind, the nearer beams and the farther ones, has at least this share of the unlike beams.
constexpr double kLeastOfEach = 0.15;

/// It counts the beams of a scan that are unlike those of another one.
struct Comparison {
  std::size_t looked_at = 0, compared = 0, nearer = 0, farther = 0;

  bool isUnlike() const {
    const auto unlike = static_cast<double>(nearer + farther);
    return compared >= kFewestBeams && 2 * compared >= looked_at &&
           unlike >= kUnlike * static_cast<double>(compared) &&
           static_cast<double>(std::min(nearer, farther)) >= kLeastOfEach * unlike;
  }
};

bool isBefore(const LaserBeam& beam, double bearing) { return beam.bearing < bearing; }

Comparison compared(const ScanProfile& before, const ScanProfile& now, const Pose2& T_before_now) {
  Comparison comparison;
  const auto& beams = now.beams();
  const std::size_t step = 1 + beams.size() / kMostBeams;
  for (std::size_t i = 0; i < beams.size(); i += step) {
    const Eigen::Vector2d end = T_before_now.transform(beams[i].end());
    const double range = end.norm(), tolerance = kTolerance + kToleranceOfRange * range;
    ++comparison.looked_at;
    const auto surfaces = before.around(std::atan2(end.y(), end.x()));
    if (!surfaces) continue;
    ++comparison.compared;
    if (beams[i].hit && range < surfaces->nearest - tolerance)
      ++comparison.nearer;
    else if (surfaces->all_met && range > surfaces->farthest + tolerance)
      ++comparison.farther;
  }
  return comparison;
}

}  // namespace

ScanProfile::ScanProfile(const LaserFan& fan) : beams_(fan.beams) {
  for (auto& beam : beams_) {
    beam.bearing = static_cast<float>(wrapAngle(static_cast<double>(beam.bearing)));
    hits_ += beam.hit ? 1 : 0;
  }
  std::sort(beams_.begin(), beams_.end(),
            [](const LaserBeam& a, const LaserBeam& b) { return a.bearing < b.bearing; });
}

std::optional<ScanProfile::Surfaces> ScanProfile::around(double bearing) const {
  Surfaces surfaces;
  const auto meet = [&](double from, double to) {
    auto beam = std::lower_bound(beams_.begin(), beams_.end(), from, isBefore);
    const auto first = beam;
    for (; beam != beams_.end() && beam->bearing <= to; ++beam) {
      surfaces.nearest = std::min(surfaces.nearest, static_cast<double>(beam->range));
      surfaces.farthest = std::max(surfaces.farthest, static_cast<double>(beam->range));
      surfaces.all_met = surfaces.all_met && beam->hit;
    }
    return beam != first;
  };
  const double from = bearing - kHalfWindow, to = bearing + kHalfWindow;
  bool has_right = meet(from, bearing), has_left = meet(bearing, to);
  if (from < -M_PI) has_right = meet(from + 2.0 * M_PI, M_PI) || has_right;
  if (to > M_PI) has_left = meet(-M_PI, to - 2.0 * M_PI) || has_left;
  return has_right && has_left ? std::make_optional(surfaces) : std::nullopt;
}

bool areUnlike(const ScanProfile& before, const ScanProfile& now, const Pose2& T_before_now) {
  return compared(before, now, T_before_now).isUnlike();
}

}  // namespace slam::relocalisation
