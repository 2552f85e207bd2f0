// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>
#include <string>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/models/motion_model.hpp"
#include "slam_core/models/speed_limit.hpp"
#include "slam_core/models/velocity_command.hpp"

namespace slam::command_odometry {

struct CommandOdometryConfig {
  static constexpr const char* kSection = "command_odometry";

  double time_constant = 0.1;
  double timeout = 0.5;
  OdometryNoise noise = {0.04, 0.01, 0.01, 0.04, false, 0.005, 0.005};
  double error_time = 0.05;
  double floor_position = 0.002;
  double floor_heading = 0.002;
  double max_speed = 10.0;
  double max_turn_rate = 10.0;

  void describe(Fields& fields);
};

/// Motion of a robot without encoders: that of its base's commands, with the covariance of the
/// velocity model (Thrun, Burgard, Fox 2005, ch. 5.3). A command holds until the next one, but no
/// longer than the base's timeout; then the base stops. The base follows a command with a lag of
/// first order, so that way and turn are the integral of
///   v(t) = c + (v(0) - c) exp(-t / time_constant)
/// of each component of the twist, and stands still once little is left of it.
///
/// The way from one command to the next is given in pieces, in each of which the robot moves
/// evenly: isBusy() until the last of them. An error lasts as long as the command is held, and not
/// less than `error_time`, so that the covariance does not depend on how often a command is
/// repeated.
///
/// A command that is more than kStampJump ahead waits for the next one: the robot may have paused,
/// or the stamp is wrong. If the next one is as far, both count.
///
/// Counted: "late", "stamp_jump", "invalid", "limited" (beyond what the robot can do; it counts as
/// the fastest that it can).
class CommandOdometry final : public OdometrySource {
 public:
  void configure(const CommandOdometryConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void set(const VelocityCommand& command) { input_ = command; }
  Status execute() override;
  bool isBusy() const override { return !pieces_.empty(); }
  std::string name() const override { return "command"; }
  const std::optional<Motion>& motion() const override { return motion_; }
  Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override;
  void reset() override;
  bool canResume() const override { return true; }
  /// The base may have had other commands meanwhile.
  void goOnLive() override { reset(); }
  void saveState(ArchiveWriter& archive) const override { archive(*this); }
  void restoreState(ArchiveReader& archive) override { archive(*this); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(input_, last_, ahead_, velocity_, odometry_pose_, pieces_, motion_, next_sequence_,
            counters_);
  }

 private:
  Status take(const VelocityCommand& command);
  Status follow(VelocityCommand command);
  void moveTo(Stamp stamp);
  void drive(const Eigen::Vector3d& twist, Stamp end, double hold);
  Pose2 step(const Eigen::Vector3d& twist, double time);
  Status reject(const std::string& reason, const std::string& sentence);

  CommandOdometryConfig config_;
  SpeedLimit limit_;
  std::optional<VelocityCommand> input_;
  std::optional<VelocityCommand> last_;   ///< that the robot follows
  std::optional<VelocityCommand> ahead_;  ///< whose stamp jumped ahead and waits for another
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< of the robot at last_
  Pose2 odometry_pose_;                                 ///< T_odom_base at last_
  std::deque<Motion> pieces_;                           ///< that have not been given yet
  std::optional<Motion> motion_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::command_odometry
