// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/laser_input.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

LaserInput::LaserInput(std::string base_frame, Sinks sinks)
    : base_frame_(std::move(base_frame)), sinks_(std::move(sinks)) {}

void LaserInput::take(const sensor_msgs::LaserScan& message) {
  const auto sweep = fromMsg(message);
  if (laser_frame_ != sweep.frame) {
    laser_frame_ = sweep.frame;
    findMount();
  }
  sinks_.scan(sweep);
}

void LaserInput::take(const tf2_msgs::TFMessage& static_transforms) {
  transforms_.set(static_transforms);
  findMount();
}

void LaserInput::findMount() {
  if (!laser_frame_) return;
  const auto pose = transforms_.mount(base_frame_, *laser_frame_);
  if (!pose) return;
  const slam::LaserMount mount{*laser_frame_, *pose};
  if (mount_ == mount) return;
  mount_ = mount;
  sinks_.mount(mount);
}

std::string LaserInput::missingTransform() const {
  if (!laser_frame_ || (mount_ && mount_->laser_frame == *laser_frame_)) return "";
  return base_frame_ + " -> " + (laser_frame_->empty() ? "(no frame)" : *laser_frame_);
}

}  // namespace slam_ros
