// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/camera_input.hpp"

#include <utility>

#include "slam_ros/image_conversions.hpp"

namespace slam_ros {

CameraInput::CameraInput(std::string base_frame, Sinks sinks)
    : base_frame_(std::move(base_frame)), sinks_(std::move(sinks)) {}

void CameraInput::take(const sensor_msgs::Image& message) { pass(fromMsg(message)); }

void CameraInput::take(const sensor_msgs::CompressedImage& message) { pass(fromMsg(message)); }

void CameraInput::take(const sensor_msgs::CameraInfo& message) {
  auto calibration = fromMsg(message);
  if (calibration_ && calibration == *calibration_) return;
  calibration_ = std::move(calibration);
  sinks_.calibration(*calibration_);
}

void CameraInput::take(const tf2_msgs::TFMessage& static_transforms) {
  transforms_.set(static_transforms);
  findMount();
}

void CameraInput::pass(const slam::Image& image) {
  if (camera_frame_ != image.frame) {
    camera_frame_ = image.frame;
    findMount();
  }
  sinks_.image(image);
}

void CameraInput::findMount() {
  if (!camera_frame_) return;
  const auto pose = transforms_.mount(base_frame_, *camera_frame_);
  const bool is_known = pose && mount_ && *camera_frame_ == mount_->camera_frame &&
                        pose->matrix() == mount_->T_base_camera.matrix();
  if (!pose || is_known) return;
  mount_ = slam::CameraMount{*camera_frame_, *pose};
  sinks_.mount(*mount_);
}

std::string CameraInput::missingTransform() const {
  if (!camera_frame_ || (mount_ && mount_->camera_frame == *camera_frame_)) return "";
  return base_frame_ + " -> " + (camera_frame_->empty() ? "(no frame)" : *camera_frame_);
}

}  // namespace slam_ros
