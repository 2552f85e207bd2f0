// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/test/painted_room.hpp"

namespace slam::test {

/// A square room whose walls are painted at random, as a camera sees it that looks ahead from
/// 0.65 m. Floor and ceiling are bare.
class TexturedRoom {
 public:
  /// @param half length of a wall [m]
  explicit TexturedRoom(std::uint64_t seed, double half = 8.0,
                        PaintedRoom::Walls walls = PaintedRoom::Walls::kDifferent)
      : room_(seed, half, 3.5, {static_cast<int>(32 * half), 0.16, 0.84}, walls) {
    setSize({320, 240});
  }

  /// Another resolution, and the calibration to it.
  void setSize(cv::Size size) {
    CameraCalibration calibration;
    calibration.width = size.width;
    calibration.height = size.height;
    calibration.fx = calibration.fy = 0.85 * size.width;
    calibration.cx = 0.5 * size.width - 0.5;
    calibration.cy = 0.5 * size.height - 0.5;
    model_ = std::make_shared<const CameraModel>(calibration);
    mount_.T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    mount_.T_base_camera.translation() << 0.1, 0.0, 0.65;
  }

  /// The camera sees this from a pose of the robot; each image has noise of its own.
  /// @param turned by how much a hand has turned the camera to the left [rad]
  CameraView look(const Pose2& T_world_base, Stamp stamp, double turned = 0.0) {
    const auto& c = model_->calibration();
    CameraView view;
    view.stamp = view.image.stamp = stamp;
    view.mount = mount_;
    view.camera = model_;
    const Pose2 T_base_camera(0.1, 0.0, turned);
    const cv::Mat clear = room_.seenFrom(T_world_base * T_base_camera, 0.65, c);
    cv::Mat noise(clear.size(), CV_32F);
    cv::RNG(0x51a3 + ++images_).fill(noise, cv::RNG::NORMAL, 0.0, 2.0);
    cv::add(clear, noise, view.image.gray, cv::noArray(), CV_8U);
    return view;
  }

 private:
  PaintedRoom room_;
  std::shared_ptr<const CameraModel> model_;
  CameraMount mount_;
  std::uint64_t images_ = 0;
};

}  // namespace slam::test
