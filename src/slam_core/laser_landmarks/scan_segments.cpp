// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/scan_segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slam::laser_landmarks {
namespace {

constexpr double kGap = 1.5;     // times the spacing; beams farther apart have one missing between
constexpr double kSigmas = 5.0;  // by which two ranges on one object differ at most

using Beams = std::vector<LaserBeam>;

double spacingOf(const Beams& beams) {
  double spacing = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < beams.size(); ++i)
    spacing = std::min(spacing, static_cast<double>(beams[i].bearing - beams[i - 1].bearing));
  return beams.size() > 1 ? spacing : 0.0;
}

bool areSideBySide(const LaserBeam& a, const LaserBeam& b, double spacing) {
  return std::abs(b.bearing - a.bearing) < kGap * spacing;
}

/// @param end the segment's outermost beam @param beam its neighbour outside the segment
Beside besideOf(const LaserBeam& end, const LaserBeam& beam, double spacing) {
  if (!areSideBySide(end, beam, spacing)) return Beside::kUnknown;
  return beam.hit && beam.range < end.range ? Beside::kNearer : Beside::kFree;
}

ScanSegment segmentAt(const Beams& beams, std::size_t begin, std::size_t end, double spacing) {
  ScanSegment segment;
  segment.beams.assign(beams.begin() + static_cast<std::ptrdiff_t>(begin),
                       beams.begin() + static_cast<std::ptrdiff_t>(end));
  if (begin > 0) segment.at_first = besideOf(beams[begin], beams[begin - 1], spacing);
  if (end < beams.size()) segment.at_last = besideOf(beams[end - 1], beams[end], spacing);
  return segment;
}

}  // namespace

ScanSegments segmentsOf(const std::vector<LaserBeam>& sweep, double max_jump,
                        double relative_sigma) {
  const double relative_jump = kSigmas * std::sqrt(2.0) * relative_sigma;
  Beams beams = sweep;
  if (beams.size() > 1 && beams.back().bearing < beams.front().bearing)
    std::reverse(beams.begin(), beams.end());
  ScanSegments found;
  found.spacing = spacingOf(beams);
  for (std::size_t begin = 0; begin < beams.size();) {
    std::size_t end = begin + 1;
    while (beams[begin].hit && end < beams.size() && beams[end].hit &&
           areSideBySide(beams[end - 1], beams[end], found.spacing) &&
           std::abs(beams[end].range - beams[end - 1].range) <=
               max_jump + relative_jump * beams[end].range)
      ++end;
    if (beams[begin].hit) found.segments.push_back(segmentAt(beams, begin, end, found.spacing));
    begin = end;
  }
  return found;
}

}  // namespace slam::laser_landmarks
