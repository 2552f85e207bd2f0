// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/brightness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slam::laser_landmarks {

Brightness::Brightness(const std::vector<LaserBeam>& beams, double range_exponent, double contrast)
    : range_exponent_(range_exponent), contrast_(contrast) {
  std::vector<double> all;
  for (const auto& beam : beams)
    if (beam.hit) all.push_back(scaled(beam));
  if (all.empty()) return;
  is_known_ = std::any_of(all.begin(), all.end(), [](double value) { return value > 0.0; });
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  median_ = std::max(0.0, *middle);
}

double Brightness::scaled(const LaserBeam& beam) const {
  return static_cast<double>(beam.intensity) *
         std::pow(static_cast<double>(beam.range), range_exponent_);
}

bool Brightness::isBright(const LaserBeam& beam) const {
  return beam.hit && beam.intensity > 0.0f && scaled(beam) > contrast_ * median_;
}

std::vector<ScanSegment> Brightness::brightPartsOf(const ScanSegment& segment) const {
  const auto& beams = segment.beams;
  std::vector<ScanSegment> parts;
  for (std::size_t begin = 0; begin < beams.size(); ++begin) {
    if (!isBright(beams[begin])) continue;
    ScanSegment part;
    part.at_first = begin == 0 ? segment.at_first : Beside::kFree;
    while (begin < beams.size() && isBright(beams[begin])) part.beams.push_back(beams[begin++]);
    part.at_last = begin == beams.size() ? segment.at_last : Beside::kFree;
    parts.push_back(part);
  }
  return parts;
}

}  // namespace slam::laser_landmarks
