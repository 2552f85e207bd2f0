// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/grid_map/scan_points.hpp"

namespace slam::scan_matching {

/// The straight row in which an end of a scan lies with those beside it.
struct Row {
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  ///< in the robot's frame, of unit length
  double length = 0.0;                                  ///< [cells]; 0: it lies in none
};

/// The rows of all ends of a scan. Ends that lie in a row lie on one surface. A map may show this
/// surface at few places only, further apart than cells, since beams that meet it far away or
/// aslant leave gaps. Such a place looks like a post there, which would hold a robot where it was
/// when the place was drawn. @return by end
std::vector<Row> rowsOf(const grid_map::ScanPoints& scan);

}  // namespace slam::scan_matching
