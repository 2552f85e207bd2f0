// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/live_robot.hpp"

namespace slam::sim {

LiveRobot::LiveRobot(const World& world, const RobotModel& robot, std::uint64_t seed,
                     bool follows_path)
    : sensors_(world, robot, seed),
      base_(sensors_.plan(), robot),
      odometer_(WheelEncoders(robot.wheels, robot.noise)) {
  const Drive drive(world.path, robot);
  base_.place(drive.pose(0.0));
  if (!follows_path) return;
  requireClearance(drive, sensors_.plan(), robot.radius);
  drive_ = drive;
}

void LiveRobot::command(const Eigen::Vector3d& velocity) {
  if (drive_) {
    base_.place(drive_->pose(time_));
    drive_.reset();
  }
  base_.command(velocity);
}

bool LiveRobot::advance(double time) {
  if (readings_ > 0 && time <= time_) return false;
  step_ = readings_ > 0 ? time - time_ : 0.0;
  time_ = time;
  if (!drive_) base_.advance(step_);
  auto noise = sensors_.wheelNoise(readings_++);
  odometer_.moveTo(pose(time), noise);
  return true;
}

Pose2 LiveRobot::pose(double time) const {
  if (drive_) return drive_->pose(time);
  return base_.pose() * Pose2::exp(base_.velocity() * (time - time_));
}

Eigen::Vector3d LiveRobot::measuredVelocity() const {
  if (step_ <= 0.0) return Eigen::Vector3d::Zero();
  return odometer_.increment() / step_;
}

}  // namespace slam::sim
