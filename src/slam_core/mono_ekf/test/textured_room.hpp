// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::test {

/// A square room whose walls are painted at random, as a camera sees it that looks ahead from
/// 0.65 m. No two walls are alike; floor and ceiling are bare.
class TexturedRoom {
 public:
  /// @param half length of a wall [m]
  explicit TexturedRoom(std::uint64_t seed, double half = 8.0) : half_(half) {
    for (std::size_t i = 0; i < walls_.size(); ++i) walls_[i] = painted(seed, i);
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
    view.image.gray = cv::Mat(c.height, c.width, CV_8U);
    const Pose2 looking = T_world_base * Pose2(0.1, 0.0, turned);
    cv::Mat noise(c.height, c.width, CV_32F);
    cv::RNG(0x51a3 + ++images_).fill(noise, cv::RNG::NORMAL, 0.0, 2.0);
    for (int row = 0; row < c.height; ++row)
      for (int column = 0; column < c.width; ++column) {
        const double left = (c.cx - column) / c.fx, up = (c.cy - row) / c.fy;
        const float gray = grayAt(looking, left, up) + noise.at<float>(row, column);
        view.image.gray.at<std::uint8_t>(row, column) = cv::saturate_cast<std::uint8_t>(gray);
      }
    return view;
  }

 private:
  static constexpr double kHeight = 3.5;   // [m]
  static constexpr double kTexels = 32.0;  // [1/m]

  cv::Mat painted(std::uint64_t seed, std::size_t wall) const {
    const int width = static_cast<int>(2.0 * half_ * kTexels) + 2;
    const int height = static_cast<int>(kHeight * kTexels) + 2;
    cv::Mat gray(height, width, CV_8U, cv::Scalar(128));
    RandomStream random(seed, wall);
    for (int i = 0; i < 32 * half_; ++i) {
      const int x = static_cast<int>(width * random.uniform());
      const int y = static_cast<int>(height * random.uniform());
      const int w = 5 + static_cast<int>(22 * random.uniform());
      const int h = 5 + static_cast<int>(22 * random.uniform());
      cv::rectangle(gray, {x, y, w, h}, 20.0 + 215.0 * random.uniform(), cv::FILLED);
    }
    cv::GaussianBlur(gray, gray, {5, 5}, 1.0);
    return gray;
  }

  /// @param left, up of a point at a distance of 1 along the camera's axis
  float grayAt(const Pose2& camera, double left, double up) const {
    const double c = std::cos(camera.theta()), s = std::sin(camera.theta());
    const double dx = c - s * left, dy = s + c * left;
    const double to_x = ((dx > 0 ? half_ : -half_) - camera.x()) / dx;
    const double to_y = ((dy > 0 ? half_ : -half_) - camera.y()) / dy;
    const bool is_x = to_x < to_y;
    const double distance = is_x ? to_x : to_y, z = 0.65 + distance * up;
    if (z < 0.0) return 90.0F;
    if (z > kHeight) return 200.0F;
    const double along = is_x ? camera.y() + distance * dy : camera.x() + distance * dx;
    const std::size_t wall = is_x ? (dx > 0 ? 0 : 1) : (dy > 0 ? 2 : 3);
    return texel(walls_[wall], (along + half_) * kTexels, z * kTexels);
  }

  static float texel(const cv::Mat& texture, double x, double y) {
    const int column = std::clamp(static_cast<int>(x), 0, texture.cols - 2);
    const int row = std::clamp(static_cast<int>(y), 0, texture.rows - 2);
    const auto fx = static_cast<float>(x - column), fy = static_cast<float>(y - row);
    const auto at = [&](int i, int j) {
      return static_cast<float>(texture.at<std::uint8_t>(row + i, column + j));
    };
    return (at(0, 0) * (1 - fx) + at(0, 1) * fx) * (1 - fy) +
           (at(1, 0) * (1 - fx) + at(1, 1) * fx) * fy;
  }

  double half_;
  std::array<cv::Mat, 4> walls_;
  std::shared_ptr<const CameraModel> model_;
  CameraMount mount_;
  std::uint64_t images_ = 0;
};

}  // namespace slam::test
