// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_line.hpp"

#include <algorithm>
#include <cmath>

namespace slam::scan_matching {
namespace {

constexpr double kMostTilt = 0.1;  // of a line [rad^2], beyond that the ends lie on a curve
/// Nearer ends may be in the wrong order, and tell no direction.
constexpr double kApartSigmas = 4.0;

/// The nearest end before (step -1) or after (step 1) another one that is not close to it.
const Eigen::Vector2d* neighbourOf(const std::vector<Eigen::Vector2d>& ends,
                                   const Eigen::Vector2d* end, int step, double apart) {
  if (end == nullptr) return nullptr;
  const auto size = static_cast<std::ptrdiff_t>(ends.size());
  for (auto i = end - ends.data() + step; i >= 0 && i < size; i += step)
    if (const auto& other = ends[static_cast<std::size_t>(i)];
        (other - *end).squaredNorm() >= apart * apart)
      return &other;
  return nullptr;
}

/// Of three ends in the order of the sweep.
std::optional<ScanLine> lineOf(const Eigen::Vector2d* first, const Eigen::Vector2d* middle,
                               const Eigen::Vector2d* last, double variance) {
  if (first == nullptr || middle == nullptr || last == nullptr) return std::nullopt;
  const Eigen::Vector2d chord = *last - *first, to_middle = *middle - *first;
  const double length = chord.norm(), along = to_middle.dot(chord) / length;
  if (!(along > 0.0 && along < length)) return std::nullopt;
  const Eigen::Vector2d direction = chord / length;
  const double offset = to_middle.x() * direction.y() - to_middle.y() * direction.x();
  const double half = 0.5 * length;
  const double tilt = (offset * offset + variance) / (half * half);
  if (!(tilt <= kMostTilt)) return std::nullopt;
  return ScanLine{direction, tilt};
}

}  // namespace

std::optional<ScanLine> scanLineAt(const std::vector<Eigen::Vector2d>& ends, std::size_t index,
                                   double reach, double variance) {
  const double apart = std::max(reach, kApartSigmas * std::sqrt(variance));
  const auto* const end = &ends[index];
  const auto* const before = neighbourOf(ends, end, -1, apart);
  const auto* const after = neighbourOf(ends, end, 1, apart);
  std::optional<ScanLine> best;
  const auto consider = [&best](const std::optional<ScanLine>& line) {
    if (line && (!best || line->tilt < best->tilt)) best = line;
  };
  consider(lineOf(before, end, after, variance));
  consider(lineOf(neighbourOf(ends, before, -1, apart), before, end, variance));
  consider(lineOf(end, after, neighbourOf(ends, after, 1, apart), variance));
  return best;
}

}  // namespace slam::scan_matching
