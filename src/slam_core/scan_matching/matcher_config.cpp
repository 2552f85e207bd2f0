// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/matcher_config.hpp"

namespace slam::scan_matching {

void MatcherConfig::describe(Fields& fields) {
  fields
      .add("spacing", &spacing,
           "of ends of beams that lie closer together than this only one is matched")
      .unit("m")
      .in(Range::atLeast(0));
  fields
      .add("sigma", &sigma,
           "standard deviation of an end's distance from the surface that it met, beside the "
           "laser's "
           "own noise")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("correlation", &correlation,
           "how many ends tell as much as one alone would: neighbouring beams err alike")
      .unit("1")
      .in(Range::atLeast(1));
  fields
      .add("doubt_share", &doubt_share,
           "where a larger share of the ends in known cells than this contradicts the map, the "
           "match is searched for in a window")
      .unit("1")
      .in(Range::open(0, 1));
  fields.add("window_position", &window_position, "half the edge of that window")
      .unit("m")
      .in(Range::closed(0.05, 5));
  fields.add("window_heading", &window_heading, "half the angle of that window")
      .unit("rad")
      .in(Range::closed(0.05, 3.1416));
  fields
      .add(
          "wide_position", &wide_position,
          "half the edge of the window where many ends contradict the map, as after wheels that "
          "stood still while the robot moved, or where a long loop has come round to its beginning")
      .unit("m")
      .in(Range::closed(0.05, 20));
  fields.add("wide_heading", &wide_heading, "half the angle of that window")
      .unit("rad")
      .in(Range::closed(0.05, 3.1416));
  fields
      .add(
          "false_alarm_hours", &false_alarm_hours,
          "mean time under way between two false alarms that the robot is lost; a longer one makes "
          "true alarms come later")
      .unit("h")
      .in(Range::closed(0.1, 1e9));
}

}  // namespace slam::scan_matching
