// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/joint_map_config.hpp"

#include "slam_core/models/landmark_map.hpp"

namespace slam::association {

void JointMapConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "build the map, or keep a loaded one fixed and only localise in it");
  places.describe(fields);
  fields
      .add("gate_probability", &gate_probability,
           "an observation is left out when a right one would lie nearer with this probability")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("initial_sigma_position", &initial_sigma_position,
           "standard deviation of the first position; the first pose defines the map frame")
      .unit("m")
      .in({0, kLargestSigmaPosition, true, false});
  fields
      .add("initial_sigma_heading", &initial_sigma_heading,
           "standard deviation of the first heading; with pi nothing is known of it")
      .unit("rad")
      .in({0, kLargestSigmaHeading, true, false});
  fields
      .add("load_inflation", &load_inflation,
           "factor on the standard deviations of a loaded map that has no joint covariance")
      .unit("1")
      .in(Range::atLeast(1));
  fields
      .add("joint_limit", &joint_limit,
           "a map of more landmarks is saved without its joint covariance, which would fill a file "
           "of hundreds of megabytes")
      .unit("1")
      .in(Range::atLeast(0));
}

}  // namespace slam::association
