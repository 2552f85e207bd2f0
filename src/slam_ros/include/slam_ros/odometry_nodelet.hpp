// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <optional>
#include <string>
#include <utility>

#include "slam_ros/motion_outputs.hpp"
#include "slam_ros/part_node.hpp"

namespace slam_ros {

/// The nodelet of an odometry source with a frame of its own, in the composition pubsub. It takes
/// in the data of its sensors, and the wheels' `odom` if the product uses them, and publishes
/// `motion`. A source's package only derives from it, names the source and exports the plugin.
class OdometryNodelet : public nodelet::Nodelet {
 protected:
  /// @param source its name in the registry, for use beside the components that the product names
  explicit OdometryNodelet(std::string source) : source_(std::move(source)) {}

 private:
  void onInit() final;

  std::string source_;
  std::optional<MotionOutputs> outputs_;
  std::optional<PartNode> node_;  // last: callbacks end before the members above
};

}  // namespace slam_ros
