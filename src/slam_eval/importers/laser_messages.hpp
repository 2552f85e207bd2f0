// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <sensor_msgs/LaserScan.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bag_writer.hpp"

namespace slam::eval {

inline constexpr char kScanTopic[] = "/scan";
inline constexpr char kLaserFrame[] = "laser";

/// What a laser saw at one stamp, beams counter-clockwise.
struct LaserReading {
  double start_angle = 0.0;   // of the first beam, in the laser's frame [rad]
  double increment = 0.0;     // between beams [rad]
  double max_range = 0.0;     // [m]
  std::vector<float> ranges;  // [m], +Inf: nothing within the laser's reach (REP-117)
};

/// A range at or beyond @p max_range [m] is no return: +Inf.
inline float rangeOrNone(double range, double max_range) {
  return range >= max_range ? std::numeric_limits<float>::infinity() : static_cast<float>(range);
}

/// @param stamp [ns] @param frame the laser's frame id
sensor_msgs::LaserScan toMessage(const LaserReading& reading, std::int64_t stamp,
                                 const std::string& frame);

/// One of a bag's first messages, /tf_static: the pose of the laser on base_link.
void addLaserMount(BagWriter& bag, const std::string& frame,
                   const geometry_msgs::Pose& T_base_laser);

}  // namespace slam::eval
