// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <utility>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/test/painted_room.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/product/test/driven_backend.hpp"

namespace slam::test {

/// Four walls with rectangles of all sizes on them, as a camera on a robot sees them. No two walls
/// are alike.
class RoomOfPictures {
 public:
  static constexpr double kHalf = 3.0;    ///< of an edge of the room [m]
  static constexpr double kHeight = 2.4;  ///< of the walls [m]

  using Walls = PaintedRoom::Walls;

  explicit RoomOfPictures(std::uint64_t seed, Walls walls = Walls::kDifferent)
      : room_(seed, kHalf, kHeight, {500, 0.04, 0.34}, walls) {}

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
    const Pose2 T_base_camera(mount().translation().x(), mount().translation().y(), 0.0);
    return room_.seenFrom(T_room_base * T_base_camera, mount().translation().z(), camera);
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
  PaintedRoom room_;
};

/// A robot that drives round and round in such a room, with odometry that errs.
class RoundOfPictures final : public SimulatedDrive {
 public:
  using Walls = RoomOfPictures::Walls;

  explicit RoundOfPictures(std::uint64_t seed, Walls walls = Walls::kDifferent)
      : room_(seed, walls), random_(seed, 100) {
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
  /// The odometry errs by this from step to step, along (x, y, theta) [m, rad].
  void errBy(const Eigen::Vector3d& sigmas) { covariance_ = sigmas.cwiseAbs2().asDiagonal(); }
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
