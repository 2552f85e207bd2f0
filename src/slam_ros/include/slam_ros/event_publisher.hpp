// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/product/step_report.hpp"

namespace slam_ros {

/// Publishes on `events` what happened in a step that others should know, one message for each
/// event.
class EventPublisher {
 public:
  EventPublisher(ros::NodeHandle handle, std::string map_frame);

  void publish(const slam::StepReport& report) const;

 private:
  std::string map_frame_;
  ros::Publisher publisher_;
};

}  // namespace slam_ros
