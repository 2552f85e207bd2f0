// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// What lies beside a segment.
enum class Beside {
  kFree,     ///< the next beam goes farther: the thing ends there
  kNearer,   ///< something nearer, which may hide a part of it
  kUnknown,  ///< no beam tells: an end of the sweep, or a beam that told nothing
};

/// Successive beams that end on one thing.
struct ScanSegment {
  std::vector<LaserBeam> beams;  ///< by rising bearing
  Beside at_first = Beside::kUnknown, at_last = Beside::kUnknown;
};

struct ScanSegments {
  std::vector<ScanSegment> segments;  ///< by rising bearing
  double spacing = 0.0;               ///< between two beams of the sweep [rad]
};

/// Cuts a scan where ranges jump by more than `max_jump` [m] and what their noise explains, where a
/// beam met nothing and where one is missing. A thing that noise cuts would have false edges.
/// @param beams in the order of the sweep, of either sense
/// @param relative_sigma standard deviation of a range, relative to it [1]
ScanSegments segmentsOf(const std::vector<LaserBeam>& beams, double max_jump,
                        double relative_sigma);

}  // namespace slam::laser_landmarks
