// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_trunks_config.hpp"

#include "slam_core/laser_landmarks/beam_fields.hpp"

namespace slam::laser_landmarks {
namespace {

void describeTrunks(LaserTrunksConfig& config, Fields& fields) {
  fields.add("min_points", &config.min_points, "fewer beams than that on one thing are no trunk")
      .in(Range::closed(1, 1000));
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
  addBeamNoise(*this, " on bark", fields);
  addSegments(*this, "a trunk whose nearest beam is longer is left out", fields);
  describeTrunks(*this, fields);
}

}  // namespace slam::laser_landmarks
