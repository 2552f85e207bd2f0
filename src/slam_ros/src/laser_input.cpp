// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/laser_input.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

LaserInput::LaserInput(std::string base_frame, Sinks sinks)
    : sinks_(std::move(sinks)),
      mount_(std::move(base_frame), [this](const auto& frame, const auto& pose) {
        sinks_.mount({frame, pose});
      }) {}

void LaserInput::take(const sensor_msgs::LaserScan& message) {
  const auto sweep = fromMsg(message);
  mount_.takeFrame(sweep.frame);
  sinks_.scan(sweep);
}

}  // namespace slam_ros
