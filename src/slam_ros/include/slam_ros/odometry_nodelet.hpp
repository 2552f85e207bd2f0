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

/// The nodelet of an odometry source with a frame of its own, in the composition pubsub: its
/// sensors' data in, and the wheels' `odom` where the product wants them; `motion` out. A source's
/// package derives from it, names the source and exports the plugin; nothing else.
class OdometryNodelet : public nodelet::Nodelet {
 protected:
  /// @param source its name in the registry, where it runs beside what the product names
  explicit OdometryNodelet(std::string source) : source_(std::move(source)) {}

 private:
  void onInit() final;

  std::string source_;
  std::optional<MotionOutputs> outputs_;
  std::optional<PartNode> node_;  // no callback may find what stands above gone
};

}  // namespace slam_ros
