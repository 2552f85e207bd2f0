// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/laser_subscriber.hpp"

#include <utility>

#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {

LaserSubscriber::LaserSubscriber(ros::NodeHandle handle, Options options, LaserInput::Sinks sinks,
                                 Pass pass)
    : options_(std::move(options)),
      pass_(std::move(pass)),
      input_(options_.base_frame, std::move(sinks)) {
  handle.resolveName(topic());  // throws now what subscribing would throw later
  start_.emplace([this, handle] { subscribe(handle); });
}

void LaserSubscriber::subscribe(ros::NodeHandle handle) {
  const auto put_in = [this](const auto& message) { input_.take(message); };
  transforms_ = subscribeThrough<tf2_msgs::TFMessage>(pass_, handle, "/tf_static", kQueue, put_in);
  scans_ = subscribeThrough<sensor_msgs::LaserScan>(pass_, handle, topic(), kQueue, put_in);
}

void LaserSubscriber::stop() {
  start_.reset();
  scans_.shutdown();
  transforms_.shutdown();
}

std::string LaserSubscriber::waiting() const {
  if (!input_.hasScan()) return "waiting for scans on " + topic();
  const auto transform = options_.robot_file_has_mount ? "" : input_.missingTransform();
  return transform.empty() ? "" : "waiting for the transform " + transform + " on /tf_static";
}

}  // namespace slam_ros
