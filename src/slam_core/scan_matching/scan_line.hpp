// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace slam::scan_matching {

/// The line along which a scan's ends lie around one of them.
struct ScanLine {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< of unit length, in the scan's frame
  double tilt = 0.0;                                     ///< variance of its direction [rad^2]
};

/// Whether a scan shows that a surface goes on beside one of its ends, where a map of few beams
/// shows a dot: the neighbouring ends in the sweep that are at least `apart` away lie on a line
/// with it, on either side or, at the edge of what is seen, on one (the point-to-line metric of
/// Censi 2008).
/// @param ends in the order of the sweep, lengths in cells like `apart`
/// @param index of the end
/// @param variance of an end across the line [cells^2]
/// @return the line that is known best; nothing where the ends lie on none
std::optional<ScanLine> scanLineAt(const std::vector<Eigen::Vector2d>& ends, std::size_t index,
                                   double reach, double variance);

}  // namespace slam::scan_matching
