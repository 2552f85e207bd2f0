// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "slam_core/common/settings.hpp"
#include "slam_core/contract/ports.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/door.hpp"
#include "slam_ros/given_mounts.hpp"
#include "slam_ros/latency_window.hpp"
#include "slam_ros/topics_config.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_ros {

/// The settings of a nodelet that concern its inputs.
struct InputOptions {
  ImageTransport image_transport = ImageTransport::kAuto;
  /// Used if nobody publishes the topic of the odometry: the transform odom -> base.
  bool odometry_from_tf = true;
  bool publishes_odometry_edge = false;  ///< this node does, so that it ignores that transform
};

/// The sources of the inputs of a part of a product, and the function that gets their data.
struct InputContext {
  /// Takes a value of some kind for the port, and the topic on which it came, for messages.
  using Put = std::function<void(const std::string& port, slam::Kind kind, const void* value,
                                 const std::string& topic)>;

  ros::NodeHandle handle;  ///< the product's namespace
  TopicsConfig topics;
  slam::FramesConfig frames;
  GivenMounts mounts;
  InputOptions options;
  Pass pass;  ///< the wrapper through which callbacks are called
  Put put;
  std::function<void(const std::string&)> warn;
};

/// The context of a nodelet by its settings; the function that gets the data is not set.
InputContext inputContext(const ros::NodeHandle& handle, slam::Settings& settings,
                          const InputOptions& options);

/// Brings data of one kind from ROS to an input; there is one object for each port. It subscribes
/// once its nodelet is loaded, and its owner destroys it before what `put` needs goes away. All
/// callbacks come from the node handle's queue.
class InputBinding {
 public:
  virtual ~InputBinding() = default;
  /// The topic of the last data, or the topic for which it waits.
  virtual const std::string& topic() const = 0;
  /// "waiting for ...", or empty if everything that a component may need has come.
  virtual std::string waiting() const = 0;
  /// Whether somebody publishes data that other components make; always true of sensors' data.
  virtual bool isConnected() const { return true; }
  /// When data came last, by the wall clock.
  LatencyWindow::Clock::time_point arrival() const { return arrival_; }

 protected:
  void noteArrival() { arrival_ = LatencyWindow::Clock::now(); }

 private:
  LatencyWindow::Clock::time_point arrival_;
};

}  // namespace slam_ros
