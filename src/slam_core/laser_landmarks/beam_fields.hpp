// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam::laser_landmarks {

/// Adds the fields of a beam's noise, which all laser detectors share.
/// @param where what the beam hits, for the description: " on bark", or empty
template <class Config>
void addBeamNoise(Config& config, const std::string& where, Fields& fields) {
  fields
      .add("sigma_range", &config.sigma_range,
           "standard deviation of a range" + where + "; laser.relative_sigma comes to it")
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

/// Adds the fields that limit a detector's range and that say where a scan is cut (segmentsOf()).
/// @param beyond what the detector does with landmarks beyond max_range, for the description
template <class Config>
void addSegments(Config& config, const std::string& beyond, Fields& fields) {
  fields.add("max_range", &config.max_range, beyond).unit("m").in(Range::above(0)).ofRobot();
  fields
      .add("max_jump", &config.max_jump,
           "beams side by side whose ranges differ by more, and by more than the noise of "
           "laser.relative_sigma explains, end on different things")
      .unit("m")
      .in(Range::above(0));
}

}  // namespace slam::laser_landmarks
