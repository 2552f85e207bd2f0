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
  pieces_.clear();
  motion_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status CommandOdometry::execute() {
  motion_.reset();
  const auto status = input_ ? take(*std::exchange(input_, std::nullopt)) : Status::ok();
  if (pieces_.empty()) return status;
  motion_ = pieces_.front();
  pieces_.pop_front();
  return status;
}

Status CommandOdometry::take(const VelocityCommand& command) {
  if (!command.twist.allFinite())
    return reject("invalid", "a command holds a value that is not a number; it is left out");
  if (last_ && command.stamp <= last_->stamp - kStampJump) last_.reset();  // a new run
  if (last_ && command.stamp <= last_->stamp)
    return reject("late",
                  command.stamp == Stamp()
                      ? "a command has the stamp 0, since its driver sets none; it is left out"
                      : "a command is not newer than the one before it; it is left out");
  const auto ahead = std::exchange(ahead_, std::nullopt);
  const bool is_confirmed = ahead && isNext(ahead->stamp, command.stamp);
  const auto before = is_confirmed ? follow(*ahead) : Status::ok();
  auto now = Status::ok();
  if (last_ && command.stamp > last_->stamp + kStampJump)
    ahead_ = command;
  else
    now = follow(command);
  if (!ahead || is_confirmed) return moreUrgent(before, now);
  return reject("stamp_jump", "a command was stamped far ahead of those around it; it is left out");
}

Status CommandOdometry::follow(VelocityCommand command) {
  const bool is_possible = limit_.allows(command.twist);
  if (!is_possible) command.twist = limit_.cut(command.twist);
  if (last_)
    moveTo(command.stamp);
  else
    velocity_.setZero();
  last_ = command;
  if (is_possible) return Status::ok();
  return reject("limited",
                "a command is beyond command_odometry.max_speed or max_turn_rate; the robot counts "
                "as one that moves as fast as these allow");
}

/// Follows the last command until it is out of date, then stops, then stands.
void CommandOdometry::moveTo(Stamp stamp) {
  constexpr double kUntilStopped = 5.0;  // time constants
  const auto stopping = std::min(stamp, last_->stamp + durationFromSeconds(config_.timeout));
  const double hold = seconds(stopping - last_->stamp);
  drive(last_->twist, stopping, hold);
  if (stopping == stamp) return;
  const auto stopped =
      std::min(stamp, stopping + durationFromSeconds(kUntilStopped * config_.time_constant));
  drive(Eigen::Vector3d::Zero(), stopped, hold);
  if (stopped == stamp) return;
  velocity_.setZero();
  drive(Eigen::Vector3d::Zero(), stamp, 0.0);
}

/// Adds the way up to a stamp. Others divide a motion in proportion to the time, so that the way of
/// a robot that does not stand is given in short pieces. @param hold an error lasts for so long [s]
void CommandOdometry::drive(const Eigen::Vector3d& twist, Stamp end, double hold) {
  constexpr Duration kLongest = std::chrono::milliseconds(200);
  const bool stands = twist.isZero(0.0) && velocity_.isZero(0.0);
  for (auto start = last_->stamp; start < end; start = last_->stamp) {
    const auto piece_end = stands ? end : std::min(end, start + kLongest);
    const double interval = seconds(piece_end - start);
    Motion piece;
    piece.sequence = next_sequence_++;
    piece.start = start;
    piece.end = piece_end;
    piece.increment = step(twist, interval);
    piece.covariance = std::max(1.0, std::max(hold, config_.error_time) / interval) *
                       VelocityMotionModel(config_.noise).covariance(piece.increment);
    const double position = config_.floor_position * config_.floor_position * interval;
    const double heading = config_.floor_heading * config_.floor_heading * interval;
    piece.covariance.diagonal() += Eigen::Vector3d(position, position, heading);
    piece.odometry_start = odometry_pose_;
    odometry_pose_ = odometry_pose_ * piece.increment;
    piece.odometry_end = odometry_pose_;
    pieces_.push_back(piece);
    last_->stamp = piece_end;
  }
}

/// Follows a command for some time [s]: changes the velocity, returns the way.
Pose2 CommandOdometry::step(const Eigen::Vector3d& twist, double time) {
  const double rest = config_.time_constant > 0.0 ? std::exp(-time / config_.time_constant) : 0.0;
  const Eigen::Vector3d lag = velocity_ - twist;
  velocity_ = twist + rest * lag;
  return Pose2::exp(time * twist + config_.time_constant * (1.0 - rest) * lag);
}

Status CommandOdometry::reject(const std::string& reason, const std::string& sentence) {
  counters_.add(reason);
  return Status::warning(sentence);
}

}  // namespace slam::command_odometry
