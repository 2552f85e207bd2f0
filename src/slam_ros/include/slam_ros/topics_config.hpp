// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/data.hpp"

namespace slam_ros {

/// Why ROS cannot use the text as the name of a topic; empty if it can.
std::string faultOfTopicName(const std::string& name);

/// The robot file's names of the product's input topics, relative to the product's namespace.
struct TopicsConfig {
  static constexpr const char* kSection = "topics";

  std::string odom = "odom";
  std::string commands = "cmd_vel_out";
  std::string observations = "observations";
  std::string motion = "motion";
  std::string camera = "camera/image_raw";
  std::string rear_camera = "rear_camera/image_raw";
  std::string ceiling_camera = "ceiling_camera/image_raw";
  std::string scan = "scan";
  std::string rear_scan = "rear_scan";
  std::string imu = "imu";

  /// The inputs that have names here, with the kinds of their data, in the order in which messages
  /// list them.
  static std::vector<std::pair<std::string, slam::Kind>> inputs();

  /// The topic of an input. An input without a name here is on the topic of its own name.
  std::string of(const std::string& input) const {
    if (input == "odom") return odom;
    if (input == "commands") return commands;
    if (input == "observations") return observations;
    if (input == "motion") return motion;
    if (input == "camera") return camera;
    if (input == "rear_camera") return rear_camera;
    if (input == "ceiling_camera") return ceiling_camera;
    if (input == "scan") return scan;
    if (input == "rear_scan") return rear_scan;
    return input == "imu" ? imu : input;
  }

  void describe(slam::Fields& fields) {
    const auto add = [&fields](const char* input, std::string* topic, const char* sentence) {
      fields.add(input, topic, sentence).checkedBy(faultOfTopicName).ofRobot();
    };
    add("odom", &odom, "the wheel driver's nav_msgs/Odometry");
    add("commands", &commands,
        "commands that the base follows, geometry_msgs/TwistStamped; diff_drive_controller "
        "publishes them with publish_cmd");
    add("observations", &observations, "landmark sensor's slam_msgs/LandmarkObservationArray");
    add("motion", &motion, "odometry source's slam_msgs/Motion");
    add("camera", &camera,
        "the camera's raw images; its compressed ones are on camera/compressed, its calibration "
        "is on the camera_info beside it");
    add("rear_camera", &rear_camera, "raw images of the second camera; others as of the camera");
    add("ceiling_camera", &ceiling_camera,
        "raw images of the camera that looks at the ceiling; others as of the camera");
    add("scan", &scan, "the laser's sensor_msgs/LaserScan");
    add("rear_scan", &rear_scan, "the second laser's sensor_msgs/LaserScan");
    add("imu", &imu, "the IMU's sensor_msgs/Imu");
  }
};

}  // namespace slam_ros
