// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/camera_renderer.hpp"
#include "slam_sim/floor_plan.hpp"
#include "slam_sim/laser_scanner.hpp"
#include "slam_sim/robot_model.hpp"
#include "slam_sim/wheel_encoders.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {

/// T_world_base some seconds before or after a reading's stamp.
using BasePath = std::function<Pose2(double seconds)>;

/// All sensors of a robot in a world. The noise of a reading depends on the seed, the sensor and
/// the reading's number, on nothing else; the const functions may be called from any thread.
class Sensors {
 public:
  Sensors(const World& world, RobotModel robot, std::uint64_t seed);
  Sensors(const Sensors&) = delete;
  Sensors& operator=(const Sensors&) = delete;

  const FloorPlan& plan() const { return plan_; }

  /// Makes a camera ready, before its first image.
  /// @throw std::invalid_argument the calibration or the optics cannot be
  void openCamera(std::size_t camera);

  RandomStream wheelNoise(std::uint64_t reading) const;
  RandomStream imuNoise(std::uint64_t reading) const;
  RandomStream commandNoise(std::uint64_t reading) const;
  LaserReadings scan(const Pose2& T_world_base, std::uint64_t reading) const;
  /// @pre the robot has a rear laser
  LaserReadings rearScan(const Pose2& T_world_base, std::uint64_t reading) const;
  /// 8 bit, one channel; the path's second 0 is the middle of the exposure.
  /// @param time since the start [s], which the light depends on
  cv::Mat image(std::size_t camera, const BasePath& T_world_base, std::uint64_t reading,
                double time) const;

 private:
  World world_;
  RobotModel robot_;
  std::uint64_t seed_;
  FloorPlan plan_;
  LaserScanner laser_, rear_laser_;
  std::shared_ptr<const Scene> scene_;
  std::map<std::size_t, CameraRenderer> cameras_;
};

/// When a sensor takes its n-th reading, after the start.
Duration timeOf(const Pace& pace, std::uint64_t reading);

}  // namespace slam::sim
