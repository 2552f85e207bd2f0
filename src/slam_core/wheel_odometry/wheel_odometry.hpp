// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/models/motion_model.hpp"

namespace slam::wheel_odometry {

struct WheelOdometryConfig {
  static constexpr const char* kSection = "wheel_odometry";

  std::string increment = "pose";
  std::string covariance = "model";
  std::string motion_model = "linear";
  std::string drive = "differential";
  double translation_scale = 1.0;
  double rotation_scale = 1.0;
  double alpha1 = 0.002;
  double alpha2 = 0.0005;
  double alpha3 = 0.002;
  double alpha4 = 0.005;
  double floor_position = 0.001;
  double floor_heading = 0.001;

  void describe(Fields& fields);
};

/// Turns a wheel driver's messages into motion increments (thesis 5.3.1): the displacement between
/// two poses, or the arc of a twist that holds until the next message; the covariance from the
/// motion model or from the twist's. The systematic part of the wheels' error is taken out first
/// (Borenstein and Feng 1996). Counted: "late", "stamp_jump",
/// "frame_change", "invalid".
class WheelOdometry final : public OdometrySource {
 public:
  void configure(const WheelOdometryConfig& config);
  void configure(Settings& settings) override;
  using OdometrySource::set;
  void set(const OdometrySample& sample) override { input_ = sample; }
  Status execute() override;
  const std::optional<Motion>& motion() const override { return motion_; }
  const Counters& counters() const override { return counters_; }
  void reset() override;

 private:
  /// True for the first stamp of a jump ahead: one message that is stamped wrongly must not make
  /// the rest late.
  bool isDoubtful(Stamp stamp);
  Status reject(const std::string& reason, const std::string& sentence);
  Pose2 incrementTo(const OdometrySample& sample) const;
  Pose2 calibrated(const Pose2& increment) const;
  Eigen::Matrix3d covarianceOf(const Pose2& increment, Duration interval) const;

  WheelOdometryConfig config_;
  std::unique_ptr<MotionModel> model_;
  OdometrySample input_;
  std::optional<OdometrySample> last_;
  std::optional<Stamp> ahead_;  ///< of the message that jumped ahead and waits for another
  Pose2 odometry_pose_;         ///< T_odom_base at last_
  std::optional<Motion> motion_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::wheel_odometry
