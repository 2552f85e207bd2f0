// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_reflectors_config.hpp"

#include "slam_core/laser_landmarks/beam_fields.hpp"

namespace slam::laser_landmarks {
namespace {

void describeBrightness(LaserReflectorsConfig& config, Fields& fields) {
  fields
      .add("contrast", &config.contrast,
           "a reflector is so many times as bright as the other things in the scan (median) would "
           "be at its range")
      .unit("1")
      .in(Range::above(1))
      .ofRobot();
  fields
      .add("range_exponent", &config.range_exponent,
           "the intensity of most things falls with this power of the range; 0 for a laser that "
           "makes up for that itself")
      .unit("1")
      .in(Range::closed(0, 4))
      .ofRobot();
}

void describeShape(LaserReflectorsConfig& config, Fields& fields) {
  fields
      .add("radius", &config.radius,
           "of the cylinders that the reflectors are wrapped around, whose axes are the landmarks; "
           "0: they are flat")
      .unit("m")
      .in(Range::closed(0, 1));
  fields
      .add("min_width", &config.min_width,
           "what is narrower, by more than the beams are apart, is no reflector")
      .unit("m")
      .in(Range::atLeast(0));
  fields
      .add("max_width", &config.max_width,
           "what is wider, by more than the beams are apart, is no reflector")
      .unit("m")
      .in(Range::above(0));
}

}  // namespace

void LaserReflectorsConfig::describe(Fields& fields) {
  describeBrightness(*this, fields);
  addBeamNoise(*this, " on a reflector", fields);
  addSegments(*this, "a reflector whose mean range is longer is left out", fields);
  describeShape(*this, fields);
}

}  // namespace slam::laser_landmarks
