// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <functional>
#include <optional>
#include <string>

#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/latency_window.hpp"
#include "slam_ros/part_inputs.hpp"
#include "slam_ros/silence_watch.hpp"

namespace slam_ros {

/// The ROS side of a part of a product without a back-end, the same for every front-end component
/// and module. It subscribes to the inputs of the part, and reports diagnostics. Its nodelet gets
/// the output by part().listen(). All callbacks come from one thread, one at a time.
class PartNode {
 public:
  struct Handles {
    ros::NodeHandle product, own;  ///< the product's namespace and the nodelet's private one
    std::string name;              ///< of the nodelet
  };

  /// @throw slam::ConfigError
  PartNode(const Handles& handles, const slam::ProductPart& part, const InputOptions& options);
  ~PartNode();
  PartNode(const PartNode&) = delete;
  PartNode& operator=(const PartNode&) = delete;

  slam::MetaCoordinator& part() { return part_; }
  const TopicsConfig& topics() const { return topics_; }
  Diagnostics& diagnostics() { return *diagnostics_; }
  const PartInputs& inputs() const { return *inputs_; }
  Pass pass();
  /// Calls a function once, as one of the callbacks, when all inputs are subscribed to and what
  /// other components make for them is published. Advertise the output there: who sees its topic
  /// expects an output for each input.
  void onceConnected(std::function<void()> call);
  /// From here on no callback of an input runs; the part itself stays.
  void stop();

  /// To be called when there is output: notes the latency since the last input.
  void noteOutput() { latency_.add(arrival_, LatencyWindow::Clock::now()); }
  /// Drops all that came, for example when the clock has jumped back.
  void reset();

  /// Called after each reset().
  std::function<void()> on_reset;
  /// Where it is set, what takes a value in runs through this.
  std::function<void(const std::function<void()>& take_in)> through;
  /// Where it is set: what the part waits for beside its inputs, or empty.
  std::function<std::string()> waits_for;
  /// Called after each value that was taken in.
  std::function<void(const std::string&, slam::Kind, const void*)> on_taken;

 private:
  void take(const std::string& port, slam::Kind kind, const void* value, const std::string& topic);
  void takeIn(const std::string& port, slam::Kind kind, const void* value,
              const std::string& topic);
  std::string waiting() const;
  std::string missing() const;
  Diagnostics::Values figures() const;

  slam::MetaCoordinator part_;
  TopicsConfig topics_;
  ClockWatch clock_;
  ros::NodeHandle handle_;
  LatencyWindow latency_;
  LatencyWindow::Clock::time_point arrival_;  ///< of the last input, by the wall clock
  SilenceWatch silence_;
  std::optional<Diagnostics> diagnostics_;
  std::optional<PartInputs> inputs_;
  ros::WallTimer connecting_;
  std::optional<AfterLoad> start_;  ///< comes after those of the inputs
};

}  // namespace slam_ros
