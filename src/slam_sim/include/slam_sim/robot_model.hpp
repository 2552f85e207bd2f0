// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion_model.hpp"
#include "slam_sim/camera_optics.hpp"

namespace slam::sim {

/// The wheels, and what their driver wrongly believes of them: the systematic error.
struct WheelBase {
  std::string drive = "differential";  ///< or "omnidirectional": four mecanum wheels
  double lever = 0.5;      ///< differential: distance of the wheels; else the sum of half the
                           ///< distances along and across [m]
  double lever_scale = 1;  ///< believed over true lever; above 1 turns are measured too small
  /// Measured over true way of each wheel: left, right; or front left, front right, rear left,
  /// rear right.
  std::vector<double> wheel_scales = {1.0, 1.0};
};

struct DriveLimits {
  double acceleration = 0.5;          ///< along the way [m/s^2]
  double lateral_acceleration = 0.5;  ///< in curves [m/s^2]
  double turn_rate = 1.0;             ///< [rad/s]
  double turn_acceleration = 3.0;     ///< of a driver's commands [rad/s^2]
  double speed = 1.5;                 ///< of a driver's commands [m/s]
};

/// A sensor's pace: its n-th reading is taken `phase + n / rate` after the start.
struct Pace {
  double rate = 10.0;  ///< [Hz]
  double phase = 0.0;  ///< [s]
};

struct LaserModel {
  std::string frame = "laser";
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the base frame [m]
  double yaw = 0.0;                                    ///< [rad]
  Pace pace;
  int beams = 682;
  double field_of_view = 4.1888;  ///< from the first to the last beam [rad]
  double min_range = 0.06;        ///< what is nearer reads -Inf [m]
  double max_range = 5.6;         ///< what is farther reads +Inf [m]
  double relative_noise = 0.01;   ///< standard deviation of a range over the range
  double angle(int beam) const { return field_of_view * (beam / (beams - 1.0) - 0.5); }
  double increment() const { return field_of_view / (beams - 1.0); }
};

struct CameraModel {
  std::string name = "camera";  ///< its topics are NAME/image_raw and so on
  std::string link_frame, optical_frame;
  Eigen::Isometry3d T_base_link = Eigen::Isometry3d::Identity();
  Pace pace;
  CameraCalibration calibration;
  CameraOptics optics;

  /// Of every camera link (x forward, z up) to the optical frame (z forward, y down), REP-103.
  static Eigen::Isometry3d linkToOptical();
  Eigen::Isometry3d T_base_optical() const { return T_base_link * linkToOptical(); }
};

/// An IMU, of which only the gyro errs. Vectors are in its own frame.
struct ImuModel {
  std::string frame = "imu_link";
  Eigen::Isometry3d T_base_imu = Eigen::Isometry3d::Identity();
  Pace pace;
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();  ///< at the start [rad/s]
  double gyro_bias_random_walk = 0.0;                   ///< [rad/s/sqrt(s)]
  double gyro_noise = 0.0;                              ///< density [rad/sqrt(s)]
  double gyro_scale = 1.0;                              ///< measured over true rate
};

/// The commands of the base's controller, which the base follows with errors.
struct CommandModel {
  Pace pace;
  double time_constant = 0.0;   ///< of the lag of first order with which the base follows [s]
  double speed_scale = 1.0;     ///< true over commanded speed
  double turn_scale = 1.0;      ///< true over commanded turn rate
  double relative_noise = 0.0;  ///< standard deviation of each command, as a part of it
};

/// All that the simulation knows of a robot.
struct RobotModel {
  std::string name;  ///< of the robot file of slam_launch that goes with it
  std::string odom_frame = "odom", base_frame = "base_link";
  double radius = 0.25;       ///< of the base, that keeps it from walls [m]
  double heading_sway = 0.0;  ///< how far the heading swings about the path's [rad]; only an
                              ///< omnidirectional base can
  WheelBase wheels;
  DriveLimits limits;
  Pace odometry;
  OdometryNoise noise;  ///< of LinearMotionModel: what one way errs does not depend on the rate
  LaserModel laser;
  std::optional<LaserModel> rear_laser;
  std::optional<ImuModel> imu;
  std::optional<CommandModel> commands;
  std::vector<CameraModel> cameras;
};

/// Reads and checks a robot's file (its form stands in the package's README).
/// @throw ConfigError all that is wrong with it, a sentence each, with file and line
RobotModel readRobotFile(const std::string& path);

}  // namespace slam::sim
