// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/place_config.hpp"

namespace slam::association {

void PlaceConfig::describe(Fields& fields) {
  fields
      .add("association_ring", &ring,
           "without ids: no landmark is begun within so many times the gate's radius around one "
           "that is known")
      .unit("1")
      .in(Range::closed(1, 10));
  fields
      .add("association_ambiguity", &ambiguity,
           "without ids: an observation is left out when another way to take it has a "
           "log-likelihood that is less than half of this below the best one's")
      .unit("1")
      .in(Range::closed(0, 100));
  fields
      .add("association_nodes", &nodes,
           "jcbb: pairings that are tried for the observations of a stamp, at most; when they do "
           "not suffice, the best ones found count")
      .unit("1")
      .in(Range::closed(1, 1000000));
  fields
      .add("association_sightings", &sightings,
           "without ids: a landmark is on trial until it has been seen so often at one place")
      .unit("1")
      .in(Range::closed(1, 100));
}

}  // namespace slam::association
