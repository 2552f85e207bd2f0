// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/laser_landmarks/laser_lines_config.hpp"
#include "slam_core/laser_landmarks/line_fit.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// A line of a scan, and where it stands in the sweep.
struct WallLine {
  Line line;
  std::size_t segment = 0;         ///< successive beams that belong together, see segmentsOf()
  std::size_t begin = 0, end = 0;  ///< its beams among the segment's
};

/// The straight lines in a scan, by rising bearing: split and merge (Pavlidis, Horowitz 1974;
/// Nguyen et al. 2005). A segment is split where a beam ends far from the straight line between its
/// first and its last one (Douglas, Peucker 1973); neighbours that one line fits are merged again.
/// The outermost beams of a line, which may have met two things, are not used.
///
/// Counted, of pieces within max_range that are no line: "few_points", "short", "not_straight".
std::vector<WallLine> wallLinesOf(const LaserScan& scan, const LaserLinesConfig& config,
                                  Counters& counters);

/// What the beams on a wall have in common, since it is not quite flat [m], shifts and turns the
/// line, however many they are.
Line withWallNoise(const Line& line, double sigma);

/// The walls: where something stands before one, or a door is in it, its parts are one line. Such
/// parts have the same direction and distance and are no farther apart than kLargestLineGap.
std::vector<Line> wallsOf(const std::vector<WallLine>& lines, double sigma_wall);

/// The corners and edges at which two lines meet: lines that follow each other in the sweep and end
/// there.
std::vector<Crossing> cornersOf(const std::vector<WallLine>& lines, const LaserLinesConfig& config);

}  // namespace slam::laser_landmarks
