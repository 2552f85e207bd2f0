// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// What lies beside a segment.
enum class Beside {
  kFree,     ///< the next beam ends farther away: the object ends there
  kNearer,   ///< a nearer object, which may hide a part of this one
  kUnknown,  ///< the end of the sweep, or a beam without a reading
};

/// Successive beams that end on one object.
struct ScanSegment {
  std::vector<LaserBeam> beams;  ///< by rising bearing
  Beside at_first = Beside::kUnknown, at_last = Beside::kUnknown;
};

struct ScanSegments {
  std::vector<ScanSegment> segments;  ///< by rising bearing
  double spacing = 0.0;               ///< between two beams of the sweep [rad]
};

/// Cuts a scan where ranges jump by more than `max_jump` [m] plus what their noise explains, where
/// a beam met nothing and where one is missing. The noise is allowed for, since an object that is
/// cut by noise would have false edges.
/// @param beams in the order of the sweep, clockwise or anticlockwise
/// @param relative_sigma standard deviation of a range, relative to it [1]
ScanSegments segmentsOf(const std::vector<LaserBeam>& beams, double max_jump,
                        double relative_sigma);

}  // namespace slam::laser_landmarks
