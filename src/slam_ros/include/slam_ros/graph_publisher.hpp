// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/contract/graph_reporter.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// Publishes `graph_markers` at a bounded rate. While nobody has subscribed, the back-end is not
/// asked for the graph.
class GraphPublisher {
 public:
  /// @param period at least [s of stamps]
  GraphPublisher(ros::NodeHandle handle, const slam::GraphReporter& reporter, std::string map_frame,
                 double period);

  /// To be called after each step: publishes if it is time.
  void update(slam::Stamp stamp);
  /// To be called when the graph has changed without a step.
  void refresh() { is_new_ = true; }
  /// To be called at intervals of the wall clock: publishes what the rate held back if no more
  /// steps come, and for new subscribers.
  void flush();
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  void publish();

  const slam::GraphReporter& reporter_;
  std::string map_frame_;
  ros::Publisher markers_;
  RateLimit rate_;
  slam::Stamp stamp_, last_flush_;  ///< of the last step, now and at the last flush()
  bool is_new_ = false;
  std::uint32_t subscribers_ = 0;
};

}  // namespace slam_ros
