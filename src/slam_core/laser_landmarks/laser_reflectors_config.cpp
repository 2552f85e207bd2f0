// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_reflectors_config.hpp"

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

void describeReflectorBeams(LaserReflectorsConfig& config, Fields& fields) {
  fields
      .add("sigma_range", &config.sigma_range,
           "standard deviation of a range on a reflector; laser.relative_sigma comes to it")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("sigma_bearing", &config.sigma_bearing,
           "standard deviation of a beam's direction, its width included")
      .unit("rad")
      .in(Range::above(0))
      .ofRobot();
  fields.add("max_range", &config.max_range, "a reflector whose nearest beam is longer is left out")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("max_jump", &config.max_jump,
           "beams side by side whose ranges differ by more end on different things")
      .unit("m")
      .in(Range::above(0));
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
  describeReflectorBeams(*this, fields);
  describeShape(*this, fields);
}

}  // namespace slam::laser_landmarks
