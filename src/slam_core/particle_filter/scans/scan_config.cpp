// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_config.hpp"

namespace slam::particle_filter {

void ScanConfig::describe(Fields& fields) {
  describePolicies(fields);
  describeUpdates(fields);
  describeDrift(fields);
  describeLikelihood(fields);
}

void ScanConfig::describePolicies(Fields& fields) {
  fields.add("proposal", &proposal,
             {{"matched", Proposal::kMatched}, {"motion", Proposal::kMotion}},
             "where a particle's new pose is drawn from: about the place where the scan fits its "
             "map best (matched), or from the motion alone (motion)");
  fields.add("weighting", &weighting,
             {{"integral", Weighting::kIntegral}, {"likelihood", Weighting::kLikelihood}},
             "a particle's weight: the scan's likelihood over all poses that the motion may have "
             "led to (integral), or at the middle of the proposal (likelihood)");
}

void ScanConfig::describeUpdates(Fields& fields) {
  fields
      .add("update_distance", &update_distance,
           "a scan updates the particles when the robot has gone so far since the last one that "
           "did; "
           "between them scans follow the robot for all particles together")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("update_angle", &update_angle, "or when it has turned by so much")
      .unit("rad")
      .in(Range::atLeast(0));
  fields.add("update_interval", &update_interval, "or after so long a time; 0: never for that")
      .unit("s")
      .in(Range::atLeast(0));
}

void ScanConfig::describeLikelihood(Fields& fields) {
  fields
      .add("outlier", &outlier,
           "likelihood of an end that has nothing to do with the map, relative to the best")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("unknown", &unknown,
           "likelihood of an end where the map knows nothing, relative to the best")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add(
          "beam_information", &beam_information,
          "share of a beam's information that counts beside that of the motion: neighbouring beams "
          "err in the same way")
      .unit("1")
      .in(Range{0, 1, true, false});
  fields
      .add(
          "weight_smoothing", &weight_smoothing,
          "the logarithm of a scan's factor on the weights is divided by this: what scans say of a "
          "particle one after the other is not independent either, as they fit the same map")
      .unit("1")
      .in(Range::atLeast(1));
  fields
      .add("lost_share", &lost_share,
           "a scan does not go into the maps when a larger share of its ends than this, of those "
           "where "
           "the map knows something, lies where the map is free")
      .unit("1")
      .in(Range::open(0, 1));
}

void ScanConfig::describeDrift(Fields& fields) {
  fields
      .add("drift_position", &drift_position,
           "standard deviation by which the way between updates errs after a metre, however well "
           "the scans fit one another; it grows with the root of the way")
      .unit("m")
      .in(Range::closed(0, 1));
  fields.add("drift_heading", &drift_heading, "the same of its heading")
      .unit("rad")
      .in(Range::closed(0, 1));
}

}  // namespace slam::particle_filter
