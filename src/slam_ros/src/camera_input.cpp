// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/camera_input.hpp"

#include <utility>

#include "slam_ros/image_conversions.hpp"

namespace slam_ros {

CameraInput::CameraInput(std::string base_frame, Sinks sinks)
    : sinks_(std::move(sinks)),
      mount_(std::move(base_frame), [this](const auto& frame, const auto& pose) {
        sinks_.mount({frame, pose});
      }) {}

void CameraInput::take(const sensor_msgs::Image& message) { pass(fromMsg(message)); }

void CameraInput::take(const sensor_msgs::CompressedImage& message) { pass(fromMsg(message)); }

void CameraInput::take(const sensor_msgs::CameraInfo& message) {
  auto calibration = fromMsg(message);
  if (calibration_ && calibration == *calibration_) return;
  calibration_ = std::move(calibration);
  sinks_.calibration(*calibration_);
}

void CameraInput::pass(const slam::Image& image) {
  mount_.takeFrame(image.frame);
  sinks_.image(image);
}

}  // namespace slam_ros
