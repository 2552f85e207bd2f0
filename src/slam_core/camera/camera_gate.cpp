// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_gate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "slam_core/contract/known_sections.hpp"

namespace slam {
namespace {

const GateRegistrar<CameraGate> kCamera(CameraConfig::kSection);
const GateRegistrar<RearCameraGate> kRearCamera(RearCameraConfig::kSection);
const GateRegistrar<CeilingCameraGate> kCeilingCamera(CeilingCameraConfig::kSection);
const SectionRegistrar<CameraConfig> kCameraSection;
const SectionRegistrar<RearCameraConfig> kRearCameraSection;
const SectionRegistrar<CeilingCameraConfig> kCeilingCameraSection;

/// Images that wait longer than this are worth a word: the first ones come before the calibration.
constexpr Duration kPatience = std::chrono::seconds(1);

/// Some drivers repeat single images; from so many in a row on a camera hangs.
constexpr int kHangs = 3;
/// Cameras with an automatic focus calibrate each image anew, within less than this share of the
/// focal length.
constexpr double kSameFocal = 0.02;

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height) + " px";
}

/// Not one of a single gray, as behind a lens cap: then the next one may well be the same.
bool isRepeated(const cv::Mat& gray, const cv::Mat& last) {
  if (gray.size() != last.size() || cv::norm(gray, last, cv::NORM_INF) > 0.0) return false;
  double least = 0.0, largest = 0.0;
  cv::minMaxLoc(gray, &least, &largest);
  return least < largest;
}

bool isZoomed(const CameraCalibration& before, const CameraCalibration& after) {
  return before.width == after.width && before.height == after.height &&
         std::abs(after.fx - before.fx) > kSameFocal * before.fx;
}

}  // namespace

void CameraGate::describe(Ports& ports) {
  ports.takes<Image>(section_, sentence_, this);
  ports.takes<CameraCalibration>(section_, "the camera's calibration", this).latched();
  ports.takes<CameraMount>(section_, "the camera's mount", this).latched();
  ports.makes<CameraView>(section_, view_);
}

void CameraGate::configure(const CameraConfig& config) {
  validate(config);
  configured_mount_ = config.mount(section_);
  calibration_.reset();
  calibration_fault_.clear();
  mount_.reset();
  if (configured_mount_) set(CameraMount());
  reset();
}

void CameraGate::reset() {
  held_.clear();
  first_.reset();
  last_.reset();
  last_gray_ = cv::Mat();
  repeats_ = 0;
  view_.reset();
  input_status_ = Status::ok();
  counters_.clear();
}

void CameraGate::set(const CameraCalibration& calibration) {
  if (calibration_ && *calibration_ == calibration) return;
  calibration_ = calibration;
  calibration_fault_ = slam::faultOf(calibration);
  if (calibration_fault_.empty()) camera_ = std::make_shared<CameraModel>(calibration);
}

void CameraGate::set(const CameraMount& mount) {
  mount_ = mount;
  if (configured_mount_) mount_->T_base_camera = *configured_mount_;
  mount_fault_ = slam::faultOf(*mount_);
}

void CameraGate::set(const Image& image) {
  if (last_ && image.stamp <= *last_ && image.stamp > *last_ - kStampJump) {
    counters_.add("late");
    input_status_ =
        Status::warning(image.stamp == Stamp()
                            ? "an image has the stamp 0, since its driver sets none; it is left out"
                            : "an image is not newer than the one before it; it is left out");
    return;
  }
  last_ = image.stamp;
  held_.push_back(image);
}

Status CameraGate::execute() {
  view_.reset();
  auto status = std::exchange(input_status_, Status::ok());
  if (held_.empty()) return status;
  if (const auto wanted = missing(held_.front()); wanted && held_.size() <= kCapacity) {
    const bool worth_a_word = held_.back().stamp - held_.front().stamp > kPatience;
    return status.isOk() && worth_a_word ? Status::warning(wanted->sentence) : status;
  }
  auto image = std::move(held_.front());
  held_.pop_front();
  const auto of_image = letOut(std::move(image));
  return of_image.isOk() ? status : of_image;
}

Status CameraGate::letOut(Image image) {
  const auto fault = faultOf(image);
  view_ = {image.stamp, std::move(image), mount_.value_or(CameraMount()), fault ? nullptr : camera_,
           false};
  if (fault) {
    counters_.add(fault->reason);
    return Status::warning(fault->sentence);
  }
  if (!first_) first_ = calibration_;
  const auto& gray = view_->image.gray;
  view_->is_repeated = isRepeated(gray, last_gray_);
  last_gray_ = gray;
  repeats_ = view_->is_repeated ? repeats_ + 1 : 0;
  if (repeats_ == 0) return Status::ok();
  counters_.add("repeated");
  if (repeats_ < kHangs) return Status::ok();
  return Status::warning(
      "the camera sent the same image again, to the bit, which tells nothing new and is left out: "
      "look whether its driver hangs (a simulated camera without noise does this while the robot "
      "stands)");
}

Counters CameraGate::held() const {
  Counters held;
  if (held_.empty()) return held;
  if (const auto wanted = missing(held_.front())) held.add(wanted->reason, held_.size());
  return held;
}

std::optional<CameraGate::Fault> CameraGate::missing(const Image& image) const {
  if (!calibration_)
    return Fault{"no_calibration",
                 "images come without the camera's calibration; its driver must publish it as "
                 "camera_info"};
  // a mount of another frame belongs to another camera
  if (!mount_ || (!configured_mount_ && mount_->camera_frame != image.frame))
    return Fault{
        "no_mount",
        "it is not known where the camera of frame '" + image.frame +
            "' is mounted; publish its static transform to the robot's base frame or give " +
            section_ + ".sensor_pose in the robot file"};
  return std::nullopt;
}

std::optional<CameraGate::Fault> CameraGate::faultOf(const Image& image) const {
  const auto& gray = image.gray;
  if (!image.fault.empty()) return Fault{"unreadable", image.fault};
  if (gray.empty() || gray.type() != CV_8UC1)
    return Fault{"unreadable", "an image is empty or is not of 8 bit gray"};
  if (auto fault = missing(image)) return fault;
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
  if (first_ && isZoomed(*first_, *calibration_))
    return Fault{"calibration_changed",
                 fmt::format("the camera's calibration has changed its focal length from {:g} to "
                             "{:g} px, so that what was seen before does not fit any more; images "
                             "are left out until it is as before: leave the zoom alone, look for "
                             "two publishers, or start again if the new calibration is right",
                             first_->fx, calibration_->fx)};
  return std::nullopt;
}

void CameraGate::saveState(ArchiveWriter& archive) const { archive(*this); }

void CameraGate::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam
