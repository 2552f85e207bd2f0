// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/camera_input.hpp"

#include <fmt/format.h>

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
  uncalibrated_.note(slam::faultOf(*calibration_));
  sinks_.calibration(*calibration_);
}

void CameraInput::pass(const slam::Image& image) {
  mount_.takeFrame(image.frame);
  unreadable_.note(image.fault);
  if (calibration_ && image.fault.empty()) of_other_size_.note(sizeFault(image));
  sinks_.image(image);
}

std::string CameraInput::sizeFault(const slam::Image& image) const {
  const auto& gray = image.gray;
  if (gray.cols == calibration_->width && gray.rows == calibration_->height) return "";
  return fmt::format("its images are of another size than its calibration, the last one {} x {} px",
                     gray.cols, gray.rows);
}

std::string CameraInput::fault() const {
  for (const auto* each : {&unreadable_, &uncalibrated_, &of_other_size_})
    if (!each->text().empty()) return each->text();
  return "";
}

}  // namespace slam_ros
