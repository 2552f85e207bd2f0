// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/topics_config.hpp"

#include <algorithm>

#include "slam_core/camera/image.hpp"
#include "slam_core/imu/imu_reading.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/velocity_command.hpp"

namespace slam_ros {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isOfName(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; }

/// As ros::names::validate() has it; names of a node's own (~) and empty parts are no topics here.
bool isTopicName(const std::string& name) {
  if (name.empty() || name.back() == '/') return false;
  if (!isLetter(name.front()) && name.front() != '/') return false;
  return name.find("//") == std::string::npos &&
         std::all_of(name.begin(), name.end(), [](char c) { return isOfName(c) || c == '/'; });
}

}  // namespace

std::string faultOfTopicName(const std::string& name) {
  if (isTopicName(name)) return "";
  return "'" + name +
         "' is no name of a topic; write letters, digits, '_' and '/' between them, with a letter "
         "or '/' first";
}

std::vector<std::pair<std::string, slam::Kind>> TopicsConfig::inputs() {
  return {{"motion", slam::kindOf<slam::Motion>()},
          {"odom", slam::kindOf<slam::OdometrySample>()},
          {"commands", slam::kindOf<slam::VelocityCommand>()},
          {"observations", slam::kindOf<slam::LandmarkObservationArray>()},
          {"camera", slam::kindOf<slam::Image>()},
          {"rear_camera", slam::kindOf<slam::Image>()},
          {"ceiling_camera", slam::kindOf<slam::Image>()},
          {"scan", slam::kindOf<slam::LaserSweep>()},
          {"rear_scan", slam::kindOf<slam::LaserSweep>()},
          {"imu", slam::kindOf<slam::ImuReading>()}};
}

}  // namespace slam_ros
