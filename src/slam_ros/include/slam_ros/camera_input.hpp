// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <optional>
#include <string>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_ros/lasting_fault.hpp"
#include "slam_ros/sensor_mount.hpp"

namespace slam_ros {

/// Turns the messages of one camera into the inputs of a component; nodelets and slam_offline share
/// it. Calibration and mount are passed on when they come and when they change. The component holds
/// the images until it has both, so that the order of arrival does not matter.
class CameraInput {
 public:
  struct Sinks {
    std::function<void(const slam::Image&)> image;
    std::function<void(const slam::CameraCalibration&)> calibration;
    std::function<void(const slam::CameraMount&)> mount;
  };

  /// @param base_frame of the robot
  CameraInput(std::string base_frame, Sinks sinks);

  void take(const sensor_msgs::Image& message);
  void take(const sensor_msgs::CompressedImage& message);
  void take(const sensor_msgs::CameraInfo& message);
  void take(const tf2_msgs::TFMessage& static_transforms) { mount_.take(static_transforms); }

  bool hasImage() const { return mount_.hasFrame(); }
  bool hasCalibration() const { return calibration_.has_value(); }
  /// Why none of the images that have come can be used; empty if some can.
  std::string fault() const;
  /// "base_link -> camera_optical_frame" if images have come and that transform has not; otherwise
  /// empty.
  std::string missingTransform() const { return mount_.missing(); }
  /// Why a bag gives no mount that could be used, as a clause; empty if it does.
  std::string lackOfMount() const { return mount_.lackInBag(); }

 private:
  void pass(const slam::Image& image);
  /// @pre there is a calibration
  std::string sizeFault(const slam::Image& image) const;

  Sinks sinks_;
  SensorMount mount_;
  std::optional<slam::CameraCalibration> calibration_;
  LastingFault unreadable_, uncalibrated_, of_other_size_;
};

}  // namespace slam_ros
