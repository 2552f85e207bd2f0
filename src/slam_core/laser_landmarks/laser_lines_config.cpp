// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_lines_config.hpp"

#include "slam_core/laser_landmarks/beam_fields.hpp"

namespace slam::laser_landmarks {
namespace {

void describeLines(LaserLinesConfig& config, Fields& fields) {
  fields
      .add("sigma_wall", &config.sigma_wall,
           "standard deviation of what the beams on one wall have in common: it is not quite flat, "
           "and more beams do not make that better")
      .unit("m")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("split_distance", &config.split_distance,
           "beams that end farther from the straight line between the first and the last are two "
           "lines; four sigmas come to it")
      .unit("m")
      .in(Range::above(0));
  fields.add("min_points", &config.min_points, "fewer beams than that are no line")
      .in(Range::closed(3, 1000));
  fields.add("min_length", &config.min_length, "a shorter line is no wall")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("max_misfit", &config.max_misfit,
           "how much larger than expected the residuals of a line may be, in standard deviations")
      .unit("1")
      .in(Range::above(0));
}

void describeCorners(LaserLinesConfig& config, Fields& fields) {
  fields
      .add("max_corner_gap", &config.max_corner_gap,
           "the corner of two lines is no farther than that from the ends of both")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("min_corner_angle", &config.min_corner_angle,
           "lines whose directions differ by less have no corner")
      .unit("rad")
      .in(Range::closed(0.1, 1.5));
}

}  // namespace

void LaserLinesConfig::describe(Fields& fields) {
  addBeamNoise(*this, "", fields);
  addSegments(*this, "longer beams are not used", fields);
  describeLines(*this, fields);
  describeCorners(*this, fields);
}

}  // namespace slam::laser_landmarks
