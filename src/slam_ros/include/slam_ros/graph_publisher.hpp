// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/contract/graph_reporter.hpp"
#include "slam_ros/rate_limit.hpp"

namespace slam_ros {

/// `graph_markers`, at a bounded rate. While nobody listens the graph is not asked for.
class GraphPublisher {
 public:
  /// @param period at least [s of stamps]
  GraphPublisher(ros::NodeHandle handle, const slam::GraphReporter& reporter, std::string map_frame,
                 double period);

  /// A step was taken: publishes when it is time.
  void update(slam::Stamp stamp);
  /// The graph has changed without a step.
  void refresh() { is_new_ = true; }
  /// Called at times of the wall: what the rate held back when no more steps come, and for those
  /// who have subscribed since.
  void flush();
  void setRate(double rate) { rate_.set(rate); }  ///< [1/s of stamps]

 private:
  void publish();

  const slam::GraphReporter& reporter_;
  std::string map_frame_;
  ros::Publisher markers_;
  RateLimit rate_;
  slam::Stamp stamp_, last_flush_;  ///< of the last step now, and at the last flush()
  bool is_new_ = false;
  std::uint32_t subscribers_ = 0;
};

}  // namespace slam_ros
