// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/gyro/gyro_calibration.hpp"
#include "slam_core/gyro/gyro_report.hpp"
#include "slam_core/gyro/gyro_track.hpp"
#include "slam_core/gyro/gyro_trust.hpp"
#include "slam_core/imu/imu_config.hpp"

namespace slam::gyro {

/// A gyro beside an odometry that measures turns as well. From its motions follow the gyro's bias,
/// with wheels its noise as well, and whether the gyro can be believed.
///
/// Counted: as GyroTrack and GyroReport.
class CalibratedGyro {
 public:
  void configure(const ImuConfig& config, const GyroReport& report);
  void reset();

  void add(const ImuSample& sample) { track_.add(sample, counters_); }
  const GyroTrack& track() const { return track_; }
  const GyroCalibration& calibration() const { return calibration_; }
  bool isProven() const { return trust_.verdict() == GyroTrust::Verdict::kProven; }

  /// Whether the gyro says how the robot turned during a motion of the odometry.
  /// @param turn of the gyro meanwhile @param is_resting the odometry has stood still for a while
  GyroUse judge(const std::optional<GyroTurn>& turn, const Motion& motion, bool is_resting) const;
  /// Time goes on by a motion of which the odometry measured no turn.
  /// @param turn of the gyro meanwhile @param gives_heading the motion has the gyro's turn
  Status pass(const std::optional<GyroTurn>& turn, const Motion& motion, bool gives_heading);
  /// Learns from a motion of the odometry and from the gyro's turn meanwhile.
  /// @param use what judge() said @param gives_heading the robot's heading is the gyro's, so that
  /// its errors add up
  Status learn(const std::optional<GyroTurn>& turn, const Motion& motion, GyroUse use,
               bool is_resting, bool gives_heading);

  Counters counters() const;
  std::uint64_t dropped() const { return counters_["gyro_late"] + counters_["gyro_stamp_jump"]; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(track_, calibration_, trust_, report_, counters_);
  }

 private:
  void calibrate(const GyroTurn& turn, const Motion& motion, bool is_resting);

  ImuConfig config_;
  GyroTrack track_;
  GyroCalibration calibration_;
  GyroTrust trust_;
  GyroReport report_;
  Counters counters_;  ///< of the track
};

}  // namespace slam::gyro
