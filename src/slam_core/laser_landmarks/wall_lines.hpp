// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/laser_landmarks/laser_lines_config.hpp"
#include "slam_core/laser_landmarks/line_fit.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// A line in a scan, with the beams that it was fitted to.
struct WallLine {
  Line line;
  std::size_t segment = 0;         ///< index of its segment in segmentsOf()
  std::size_t begin = 0, end = 0;  ///< its beams within that segment: [begin, end)
};

/// The straight lines in a scan, by rising bearing: split and merge (Pavlidis, Horowitz 1974;
/// Nguyen et al. 2005). A segment is split where a beam ends far from the straight line between its
/// first and its last one (Douglas, Peucker 1973); neighbours that one line fits are merged again.
/// The outermost beams of a line are not used, since they may have hit two objects at once.
///
/// Pieces within max_range that are no line are counted: "few_points", "short", "not_straight".
std::vector<WallLine> wallLinesOf(const LaserScan& scan, const LaserLinesConfig& config,
                                  Counters& counters);

/// The line with the covariance of a wall that is not quite flat. Its unevenness is an error that
/// all beams on the wall share: it shifts and turns the line, however many beams there are.
/// @param sigma of that error [m]
Line withWallNoise(const Line& line, double sigma);

/// The walls in a scan, with withWallNoise(). Lines on either side of an object that hides the
/// wall, or of a door, are parts of one wall if they have the same direction and distance and are
/// no farther apart than kLargestLineGap.
std::vector<Line> wallsOf(const std::vector<WallLine>& lines, double sigma_wall);

/// The corners, convex and concave, where two lines meet that follow each other in the sweep.
std::vector<Crossing> cornersOf(const std::vector<WallLine>& lines, const LaserLinesConfig& config);

}  // namespace slam::laser_landmarks
