// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/command_odometry/command_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::command_odometry {
namespace {

const Registrar<OdometrySource, CommandOdometry> kRegistrar("command");
const SectionRegistrar<CommandOdometryConfig> kSectionRegistrar;

}  // namespace

void CommandOdometry::configure(const CommandOdometryConfig& config) {
  validate(config);
  config_ = config;
  limit_ = {config.max_speed, config.max_turn_rate};
  reset();
}

void CommandOdometry::configure(Settings& settings) {
  configure(settings.read<CommandOdometryConfig>());
}

void CommandOdometry::describe(Ports& ports) {
  ports.takes<VelocityCommand>("commands", "commands", this);
  ports.makes<Motion>("motion", motion_);
}

std::uint64_t CommandOdometry::dropped() const {
  return counters_["late"] + counters_["invalid"] + counters_["stamp_jump"];
}

void CommandOdometry::reset() {
  input_.reset();
  last_.reset();
  ahead_.reset();
  velocity_.setZero();
  odometry_pose_ = Pose2();
  motion_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status CommandOdometry::execute() {
  motion_.reset();
  if (!input_) return Status::ok();
  const auto command = *std::exchange(input_, std::nullopt);
  if (!command.twist.allFinite())
    return reject("invalid", "a command holds a value that is not a number; it is left out");
  if (last_ && command.stamp <= last_->stamp - kStampJump) last_.reset();  // a new run
  if (last_ && command.stamp <= last_->stamp)
    return reject("late", "a command is not newer than the one before it; it is left out");
  const auto ahead = std::exchange(ahead_, std::nullopt);
  const bool is_confirmed = ahead && command.stamp > ahead->stamp;
  if (last_ && !is_confirmed && command.stamp > last_->stamp + kStampJump) {
    ahead_ = command;
    return Status::ok();
  }
  const auto before = is_confirmed ? follow(*ahead) : Status::ok();
  const auto now = follow(command);
  if (!ahead || is_confirmed) return moreUrgent(before, now);
  return reject("stamp_jump", "a command was stamped far ahead of those around it; it is left out");
}

Status CommandOdometry::follow(VelocityCommand command) {
  const bool is_possible = limit_.allows(command.twist);
  if (!is_possible) command.twist = limit_.cut(command.twist);
  if (last_)
    take(motionTo(command.stamp));
  else
    velocity_.setZero();
  last_ = command;
  if (is_possible) return Status::ok();
  return reject("limited",
                "a command is beyond command_odometry.max_speed or max_turn_rate; the robot counts "
                "as one that moves as fast as these allow");
}

Motion CommandOdometry::motionTo(Stamp stamp) {
  const double interval = seconds(stamp - last_->stamp);
  const double driven = std::min(interval, config_.timeout);
  Motion motion;
  motion.start = last_->stamp;
  motion.end = stamp;
  motion.increment = drive(last_->twist, driven);
  if (interval > driven)
    motion.increment = motion.increment * drive(Eigen::Vector3d::Zero(), interval - driven);
  const double position = config_.floor_position * config_.floor_position * interval;
  const double heading = config_.floor_heading * config_.floor_heading * interval;
  motion.covariance = VelocityMotionModel(config_.noise).covariance(motion.increment);
  motion.covariance.diagonal() += Eigen::Vector3d(position, position, heading);
  motion.odometry_start = odometry_pose_;
  motion.odometry_end = odometry_pose_ * motion.increment;
  return motion;
}

/// Follows a command for some time [s]: moves on the velocity, returns the way.
Pose2 CommandOdometry::drive(const Eigen::Vector3d& twist, double time) {
  const double rest = config_.time_constant > 0.0 ? std::exp(-time / config_.time_constant) : 0.0;
  const Eigen::Vector3d lag = velocity_ - twist;
  velocity_ = twist + rest * lag;
  return Pose2::exp(time * twist + config_.time_constant * (1.0 - rest) * lag);
}

void CommandOdometry::take(const Motion& motion) {
  odometry_pose_ = motion.odometry_end;
  const auto sequence = motion_ ? motion_->sequence : next_sequence_++;
  motion_ = motion_ ? joined(*motion_, motion) : motion;
  motion_->sequence = sequence;
}

Status CommandOdometry::reject(const std::string& reason, const std::string& sentence) {
  counters_.add(reason);
  return Status::warning(sentence);
}

}  // namespace slam::command_odometry
