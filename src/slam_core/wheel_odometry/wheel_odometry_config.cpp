// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/wheel_odometry/wheel_odometry.hpp"

namespace slam::wheel_odometry {

void WheelOdometryConfig::describe(Fields& fields) {
  fields
      .add("increment", &increment, {{"pose", Increment::kPose}, {"twist", Increment::kTwist}},
           "what the increment is made of; twist where there is no pose")
      .ofRobot();
  fields
      .add("covariance", &covariance,
           {{"model", Covariance::kModel}, {"twist", Covariance::kTwist}},
           "the motion model's, or the message's twist covariance")
      .ofRobot();
  fields
      .add("motion_model", &motion_model,
           "variance proportional to way and angle (linear), or to their squares (Eq. 5.2)")
      .oneOf(motionModelNames())
      .ofRobot();
  fields
      .add("drive", &drive,
           {{"differential", Drive::kDifferential}, {"omnidirectional", Drive::kOmnidirectional}},
           "an omnidirectional base slips across its way as much as along it")
      .ofRobot();
  fields
      .add("translation_scale", &translation_scale,
           "true way over measured way, from a calibration of the wheels")
      .unit("1")
      .in(Range::open(0, 10))
      .ofRobot();
  fields
      .add("rotation_scale", &rotation_scale,
           "true angle over measured angle, from a calibration of the wheels")
      .unit("1")
      .in(Range::open(0, 10))
      .ofRobot();
  fields.add("alpha1", &alpha1, "translation to translation variance")
      .unit("m^2/m; quadratic: 1")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("alpha2", &alpha2, "rotation to translation variance")
      .unit("m^2/rad; quadratic: m^2/rad^2")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("alpha3", &alpha3, "translation to rotation variance")
      .unit("rad^2/m; quadratic: rad^2/m^2")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("alpha4", &alpha4, "rotation to rotation variance")
      .unit("rad^2/rad; quadratic: 1")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("floor_position", &floor_position,
           "standard deviation of the position after one second, standing or not")
      .unit("m/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("floor_heading", &floor_heading,
           "standard deviation of the heading after one second, standing or not")
      .unit("rad/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("max_speed", &max_speed,
           "what the robot can do at most; odometry that moves further is not believed")
      .unit("m/s")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("max_turn_rate", &max_turn_rate,
           "what the robot can do at most; odometry that turns further is not believed")
      .unit("rad/s")
      .in(Range::above(0))
      .ofRobot();
}

}  // namespace slam::wheel_odometry
