// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/wheel_odometry/wheel_odometry.hpp"

namespace slam::wheel_odometry {
namespace {

void describeModel(WheelOdometryConfig& config, Fields& fields) {
  fields
      .add("increment", &config.increment,
           {{"pose", WheelOdometryConfig::Increment::kPose},
            {"twist", WheelOdometryConfig::Increment::kTwist}},
           "what the increment is made of; twist where there is no pose")
      .ofRobot();
  fields
      .add("covariance", &config.covariance,
           {{"model", WheelOdometryConfig::Covariance::kModel},
            {"twist", WheelOdometryConfig::Covariance::kTwist}},
           "the motion model's, or the message's twist covariance")
      .ofRobot();
  fields
      .add("motion_model", &config.motion_model,
           "variance proportional to way and angle (linear), to their squares, of a turn before a "
           "drive (quadratic, Eq. 5.2) or of an arc with a final rotation (velocity, Thrun et al. "
           "2005, ch. 5.3)")
      .oneOf(motionModelNames())
      .ofRobot();
  fields
      .add("drive", &config.drive,
           {{"differential", WheelOdometryConfig::Drive::kDifferential},
            {"omnidirectional", WheelOdometryConfig::Drive::kOmnidirectional}},
           "an omnidirectional base slips across its way as much as along it")
      .ofRobot();
}

void describeCalibration(WheelOdometryConfig& config, Fields& fields) {
  fields
      .add("translation_scale", &config.translation_scale,
           "true way over measured way, from a calibration of the wheels")
      .unit("1")
      .in(Range::open(0, 10))
      .ofRobot();
  fields
      .add("rotation_scale", &config.rotation_scale,
           "true angle over measured angle, from a calibration of the wheels")
      .unit("1")
      .in(Range::open(0, 10))
      .ofRobot();
  fields
      .add("drift", &config.drift,
           "the robot turns by this on each metre ahead and the wheels do not measure it, from a "
           "calibration of the wheels")
      .unit("rad/m")
      .in(Range::open(-1, 1))
      .ofRobot();
}

void describeNoise(WheelOdometryConfig& config, Fields& fields) {
  fields.add("alpha1", &config.alpha1, "translation to translation variance")
      .unit("m^2/m; quadratic, velocity: 1")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("alpha2", &config.alpha2, "rotation to translation variance")
      .unit("m^2/rad; quadratic, velocity: m^2/rad^2")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("alpha3", &config.alpha3, "translation to rotation variance")
      .unit("rad^2/m; quadratic, velocity: rad^2/m^2")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("alpha4", &config.alpha4, "rotation to rotation variance")
      .unit("rad^2/rad; quadratic, velocity: 1")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("alpha5", &config.alpha5,
           "translation to final rotation variance, of the velocity model alone")
      .unit("rad^2/m^2")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("alpha6", &config.alpha6,
           "rotation to final rotation variance, of the velocity model alone")
      .unit("1")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("floor_position", &config.floor_position,
           "standard deviation of the position after one second, standing or not")
      .unit("m/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("floor_heading", &config.floor_heading,
           "standard deviation of the heading after one second, standing or not")
      .unit("rad/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
}

void describeLimits(WheelOdometryConfig& config, Fields& fields) {
  fields
      .add("max_speed", &config.max_speed,
           "what the robot can do at most; odometry that moves further is not believed")
      .unit("m/s")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("max_turn_rate", &config.max_turn_rate,
           "what the robot can do at most; odometry that turns further is not believed")
      .unit("rad/s")
      .in(Range::above(0))
      .ofRobot();
}

}  // namespace

void WheelOdometryConfig::describe(Fields& fields) {
  describeModel(*this, fields);
  describeCalibration(*this, fields);
  describeNoise(*this, fields);
  describeLimits(*this, fields);
}

}  // namespace slam::wheel_odometry
