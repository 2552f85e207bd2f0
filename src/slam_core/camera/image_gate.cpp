// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/image_gate.hpp"

#include <utility>

namespace slam {
namespace {

/// A stamp this much older than the last one is the beginning of a new run.
/// Images that wait longer than this are worth a word: the first ones come before the calibration.
constexpr Duration kPatience = std::chrono::seconds(1);

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height) + " px";
}

}  // namespace

void ImageGate::configure(const CameraConfig& config, const std::string& section) {
  validate(config);
  section_ = section;
  configured_mount_ = config.mount(section);
  calibration_.reset();
  calibration_fault_.clear();
  mount_.reset();
  if (configured_mount_) set(CameraMount());
  reset();
}

void ImageGate::reset() {
  held_.clear();
  last_.reset();
  image_.reset();
  usable_ = false;
  input_status_ = Status::ok();
}

void ImageGate::set(const CameraCalibration& calibration) {
  if (calibration_ && *calibration_ == calibration) return;
  calibration_ = calibration;
  calibration_fault_ = faultOf(calibration);
  if (calibration_fault_.empty()) camera_ = CameraModel(calibration);
}

void ImageGate::set(const CameraMount& mount) {
  mount_ = mount;
  if (configured_mount_) mount_->T_base_camera = *configured_mount_;
  mount_fault_ = faultOf(*mount_);
}

void ImageGate::set(const Image& image, Counters& counters) {
  if (last_ && image.stamp <= *last_ && image.stamp > *last_ - kStampJump) {
    counters.add("late");
    input_status_ = Status::warning("an image is not newer than the one before it; it is left out");
    return;
  }
  last_ = image.stamp;
  held_.push_back(image);
}

Status ImageGate::next(Counters& counters) {
  image_.reset();
  usable_ = false;
  auto status = std::exchange(input_status_, Status::ok());
  if (held_.empty()) return status;
  if (const auto wanted = missing(held_.front()); wanted && held_.size() <= kCapacity) {
    const bool worth_a_word = held_.back().stamp - held_.front().stamp > kPatience;
    return status.isOk() && worth_a_word ? Status::warning(wanted->sentence) : status;
  }
  image_ = std::move(held_.front());
  held_.pop_front();
  if (const auto fault = faultOfImage()) {
    counters.add(fault->reason);
    return Status::warning(fault->sentence);
  }
  usable_ = true;
  return status;
}

std::optional<ImageGate::Fault> ImageGate::missing(const Image& image) const {
  if (!calibration_)
    return Fault{"no_calibration",
                 "images come without the camera's calibration; its driver must publish it as "
                 "camera_info"};
  // of another frame it is another camera's
  if (!mount_ || (!configured_mount_ && mount_->camera_frame != image.frame))
    return Fault{
        "no_mount",
        "it is not known where the camera of frame '" + image.frame +
            "' is mounted; publish its static transform to the robot's base frame or give " +
            section_ + ".sensor_pose in the robot file"};
  return std::nullopt;
}

std::optional<ImageGate::Fault> ImageGate::faultOfImage() const {
  const auto& gray = image_->gray;
  if (!image_->fault.empty()) return Fault{"unreadable", image_->fault};
  if (gray.empty() || gray.type() != CV_8UC1)
    return Fault{"unreadable", "an image is empty or is not of 8 bit gray"};
  if (auto fault = missing(*image_)) return fault;
  if (!calibration_fault_.empty())
    return Fault{"bad_calibration", "the camera's calibration cannot be used: " +
                                        calibration_fault_ + "; correct its camera_info"};
  if (!mount_fault_.empty())
    return Fault{"bad_mount", "the camera's mount cannot be used: " + mount_fault_ +
                                  "; correct its transform to the robot's base frame"};
  if (gray.cols != calibration_->width || gray.rows != calibration_->height)
    return Fault{"image_size", "an image of " + sizeText(gray.cols, gray.rows) +
                                   " does not fit the calibration for " +
                                   sizeText(calibration_->width, calibration_->height) +
                                   "; calibrate the camera at the resolution in use"};
  return std::nullopt;
}

}  // namespace slam
