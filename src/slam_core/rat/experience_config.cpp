// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/experience_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam::rat {

void ExperienceConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "slam builds the map; localization in a fixed map is refused");
  fields
      .add("largest_distance", &largest_distance,
           "the packet of pose cells is where an experience has it when it is not further off")
      .unit("cells")
      .in(Range::open(0, 10));
  fields.add("relaxations", &relaxations, "how often a step relaxes the map")
      .unit("1")
      .in(Range::closed(0, 10000));
  fields
      .add("correction", &correction,
           "the share of a link's contradiction by which both ends give way together")
      .unit("1")
      .in(Range::closed(0.01, 1));
  fields
      .add("most_experiences", &most_experiences,
           "so many experiences are remembered; beyond them the map does not grow")
      .unit("1")
      .in(Range::closed(1, 1000000));
  fields
      .add("most_steps", &most_steps,
           "so many steps of the way are remembered, the last ones: they are revised with the map, "
           "and stand in places.csv")
      .unit("1")
      .in(Range::closed(1, 100000000));
}

void requireUsable(const ExperienceConfig& config) {
  validate(config);
  if (config.mode != BackendMode::kSlam)
    throw ConfigError(
        "rat.mode: RatSLAM cannot keep its map fixed and localise in it: set mode to slam, or take "
        "another back-end");
}

}  // namespace slam::rat
