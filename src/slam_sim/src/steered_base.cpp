// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/steered_base.hpp"

#include <algorithm>

namespace slam::sim {

void SteeredBase::place(const Pose2& T_world_base) {
  pose_ = T_world_base;
  velocity_.setZero();
  command_.setZero();
  touches_ = false;
}

void SteeredBase::command(const Eigen::Vector3d& velocity) {
  if (!velocity.allFinite()) return;
  command_ = velocity;
  if (robot_.wheels.drive == "differential") command_.y() = 0.0;
  const double speed = command_.head<2>().norm();
  if (speed > robot_.limits.speed) command_.head<2>() *= robot_.limits.speed / speed;
  command_.z() = std::clamp(command_.z(), -robot_.limits.turn_rate, robot_.limits.turn_rate);
  command_age_ = 0.0;
}

void SteeredBase::approachCommand(double dt) {
  command_age_ += dt;
  if (command_age_ > kCommandLifetime) command_.setZero();
  Eigen::Vector2d change = command_.head<2>() - velocity_.head<2>();
  const double most = robot_.limits.acceleration * dt;
  if (change.norm() > most) change *= most / change.norm();
  velocity_.head<2>() += change;
  const double turn = robot_.limits.turn_acceleration * dt;
  velocity_.z() += std::clamp(command_.z() - velocity_.z(), -turn, turn);
}

/// Only what brings it nearer: it can always drive away.
bool SteeredBase::isBlocked(const Pose2& next) const {
  double now = 0.0, then = 0.0;
  plan_.nearest(pose_.position(), 0.0, &now);
  plan_.nearest(next.position(), 0.0, &then);
  return then < robot_.radius && then < now;
}

void SteeredBase::advance(double dt) {
  approachCommand(dt);
  Pose2 next = pose_ * Pose2::exp(velocity_ * dt);
  touches_ = isBlocked(next);
  if (touches_) {
    velocity_.head<2>().setZero();
    next = pose_ * Pose2::exp(velocity_ * dt);
  }
  pose_ = next;
}

}  // namespace slam::sim
