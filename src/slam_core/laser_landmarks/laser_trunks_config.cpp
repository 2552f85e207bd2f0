// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_trunks_config.hpp"

namespace slam::laser_landmarks {
namespace {

void describeNoise(LaserTrunksConfig& config, Fields& fields) {
  fields
      .add("sigma_range", &config.sigma_range,
           "standard deviation of a range on bark; laser.relative_sigma comes to it")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("sigma_bearing", &config.sigma_bearing,
           "standard deviation of a beam's direction, its width included")
      .unit("rad")
      .in(Range::above(0))
      .ofRobot();
}

void describeSegments(LaserTrunksConfig& config, Fields& fields) {
  fields.add("max_range", &config.max_range, "a trunk whose nearest beam is longer is left out")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("max_jump", &config.max_jump,
           "beams side by side whose ranges differ by more, and by more than the noise of "
           "laser.relative_sigma explains, end on different things")
      .unit("m")
      .in(Range::above(0));
  fields.add("min_points", &config.min_points, "fewer beams than that on one thing are no trunk")
      .in(Range::closed(1, 1000));
}

void describeTrunks(LaserTrunksConfig& config, Fields& fields) {
  fields.add("min_diameter", &config.min_diameter, "a thinner thing is no trunk")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("max_diameter", &config.max_diameter, "a thicker thing is no trunk")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("max_misfit", &config.max_misfit,
           "how much larger than expected the residuals of a circle may be, in standard deviations")
      .unit("1")
      .in(Range::above(0));
}

}  // namespace

void LaserTrunksConfig::describe(Fields& fields) {
  describeNoise(*this, fields);
  describeSegments(*this, fields);
  describeTrunks(*this, fields);
}

}  // namespace slam::laser_landmarks
