// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/product/test/driven_backend.hpp"

namespace slam::test {

/// Four walls with rectangles of all sizes on them, as a camera on a robot sees them. No two walls
/// are alike.
class RoomOfPictures {
 public:
  static constexpr double kHalf = 3.0;    ///< of an edge of the room [m]
  static constexpr double kHeight = 2.4;  ///< of the walls [m]

  explicit RoomOfPictures(std::uint64_t seed) {
    for (std::size_t i = 0; i < walls_.size(); ++i) walls_[i] = picture(seed, i);
  }

  static CameraCalibration calibration(int width = 320) {
    CameraCalibration calibration;
    calibration.width = width;
    calibration.height = width * 3 / 4;
    calibration.fx = calibration.fy = 0.85 * width;
    calibration.cx = 0.5 * (calibration.width - 1);
    calibration.cy = 0.5 * (calibration.height - 1);
    return calibration;
  }
  /// 0.1 m ahead of the robot's centre, 0.6 m above the floor, looking ahead.
  static Eigen::Isometry3d mount() {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    T.translation() << 0.1, 0.0, 0.6;
    return T;
  }

  /// @param T_room_base of the robot, within the walls
  cv::Mat seenFrom(const Pose2& T_room_base, const CameraCalibration& camera) const {
    cv::Mat image(camera.height, camera.width, CV_8U);
    const Eigen::Vector2d centre = T_room_base.transform(mount().translation().head<2>());
    for (int v = 0; v < image.rows; ++v)
      for (int u = 0; u < image.cols; ++u) {
        const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
        const Eigen::Vector3d in_base = mount().linear() * ray;
        const Eigen::Vector2d on_floor = T_room_base.rotation() * in_base.head<2>();
        image.at<std::uint8_t>(v, u) = seenAlong(centre, on_floor, in_base.z());
      }
    return image;
  }
  CameraView view(Stamp stamp, const Pose2& T_room_base, int width = 320) const {
    CameraView view;
    view.stamp = view.image.stamp = stamp;
    view.mount.T_base_camera = mount();
    view.camera = std::make_shared<const CameraModel>(calibration(width));
    view.image.gray = seenFrom(T_room_base, view.camera->calibration());
    return view;
  }

 private:
  static constexpr int kTexels = 100;  // a metre

  static cv::Mat picture(std::uint64_t seed, std::size_t wall) {
    const cv::Size size(static_cast<int>(2 * kHalf * kTexels), static_cast<int>(kHeight * kTexels));
    cv::Mat picture(size, CV_8U, cv::Scalar(130));
    RandomStream random(seed, wall);
    for (int i = 0; i < 500; ++i) {
      const cv::Point at(static_cast<int>(size.width * random.uniform()),
                         static_cast<int>(size.height * random.uniform()));
      const int edge = 4 + static_cast<int>(30 * random.uniform() * random.uniform());
      cv::rectangle(picture, at, at + cv::Point(edge, 2 + edge / 2),
                    cv::Scalar(255.0 * random.uniform()), cv::FILLED);
    }
    return picture;
  }

  /// Floor and ceiling are plain.
  std::uint8_t seenAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& ray,
                         double rise) const {
    double least = 1e9;
    std::size_t wall = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto axis = static_cast<Eigen::Index>(i / 2);
      const double reach = ((i % 2 == 0 ? kHalf : -kHalf) - from[axis]) / ray[axis];
      if (!(reach > 0.0) || reach >= least) continue;
      least = reach;
      wall = i;
    }
    const Eigen::Vector2d at = from + least * ray;
    const double height = mount().translation().z() + least * rise;
    if (height <= 0.0 || height >= kHeight) return 90;
    return sampled(walls_[wall], (at[wall / 2 == 0 ? 1 : 0] + kHalf) * kTexels,
                   (kHeight - height) * kTexels);
  }

  static std::uint8_t sampled(const cv::Mat& picture, double x, double y) {
    const int left = std::clamp(static_cast<int>(x), 0, picture.cols - 2);
    const int top = std::clamp(static_cast<int>(y), 0, picture.rows - 2);
    const double right = std::clamp(x - left, 0.0, 1.0), below = std::clamp(y - top, 0.0, 1.0);
    const auto value = [&](int dy, int dx) {
      return static_cast<double>(picture.at<std::uint8_t>(top + dy, left + dx));
    };
    const double above = (1.0 - right) * value(0, 0) + right * value(0, 1);
    const double under = (1.0 - right) * value(1, 0) + right * value(1, 1);
    return static_cast<std::uint8_t>(std::lround((1.0 - below) * above + below * under));
  }

  std::array<cv::Mat, 4> walls_;
};

/// A robot that drives round and round in such a room, with odometry that errs.
class RoundOfPictures final : public SimulatedDrive {
 public:
  explicit RoundOfPictures(std::uint64_t seed) : room_(seed), random_(seed, 100) {
    covariance_.diagonal() << 4e-6, 1e-6, 4e-6;
  }

  Pose2 give(ComponentDriver& inputs) override {
    const auto motion = drive();
    inputs.set(motion);
    inputs.set(room_.view(motion.end, start() * truth_));
    return truth_;
  }
  int stepsOfALap() const override { return 126; }

  const RoomOfPictures& room() const { return room_; }
  /// Where the robot is in the room.
  Pose2 place() const { return start() * truth_; }
  /// The robot is carried: its odometry notices nothing.
  void carry(const Pose2& by) { truth_ = truth_ * by; }

  Motion drive() {
    Motion motion;
    motion.sequence = count_;
    motion.start = stamp(count_);
    motion.end = stamp(++count_);
    const Pose2 step = Pose2::exp({0.06, 0.0, 0.05});
    truth_ = truth_ * step;
    const Eigen::Vector3d noise(random_.gaussian(), random_.gaussian(), random_.gaussian());
    const Eigen::Vector3d sigmas = covariance_.diagonal().cwiseSqrt();
    motion.increment = Pose2::fromVector(step.vector() + sigmas.cwiseProduct(noise));
    motion.covariance = covariance_;
    motion.odometry_start = odometry_;
    odometry_ = motion.odometry_end = odometry_ * motion.increment;
    motion.odometry_frame = "odom";
    motion.base_frame = "base_link";
    return motion;
  }

 private:
  static Pose2 start() { return {0.0, -1.2, 0.0}; }
  static Stamp stamp(std::uint64_t count) {
    return stampFromNanoseconds(1000000000000) + count * std::chrono::milliseconds(100);
  }

  RoomOfPictures room_;
  RandomStream random_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  Pose2 truth_, odometry_;
  std::uint64_t count_ = 0;
};

}  // namespace slam::test
