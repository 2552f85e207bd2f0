// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/models/coasting.hpp"
#include "slam_core/models/motion_model.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/usual_interval.hpp"
#include "slam_core/models/speed_limit.hpp"

namespace slam::wheel_odometry {

struct WheelOdometryConfig {
  static constexpr const char* kSection = "wheel_odometry";

  enum class Increment { kPose, kTwist };
  enum class Covariance { kModel, kTwist };
  enum class Drive { kDifferential, kOmnidirectional };

  Increment increment = Increment::kPose;
  Covariance covariance = Covariance::kModel;
  std::string motion_model = "linear";
  Drive drive = Drive::kDifferential;
  double translation_scale = 1.0;
  double rotation_scale = 1.0;
  double drift = 0.0;
  double alpha1 = 0.002;
  double alpha2 = 0.0005;
  double alpha3 = 0.002;
  double alpha4 = 0.005;
  double alpha5 = 0.0005;
  double alpha6 = 0.001;
  double floor_position = 0.001;
  double floor_heading = 0.001;
  double max_speed = 10.0;
  double max_turn_rate = 10.0;

  void describe(Fields& fields);
};

/// Turns a wheel driver's messages into motion increments (thesis 5.3.1): the displacement between
/// two poses, or the arc of a twist that holds until the next message; the covariance from the
/// motion model or from the twist's. The systematic part of the wheels' error is taken out first
/// (Borenstein and Feng 1996).
///
/// A pose that the robot cannot have reached, or that is the origin out of turn, waits for the next
/// one: it is left out where that one is near the last pose, else the driver's pose has jumped, as
/// when it was restarted. Then the motion goes on from the new pose, and that up to there is taken
/// from the twist, or else from the last velocity, with a covariance to match. A twist that the
/// robot cannot have is made up for in the same way.
///
/// Counted: "late", "stamp_jump", "frame_change", "invalid", "implausible" (a pose that waited, a
/// twist), "pose_jump".
class WheelOdometry final : public OdometrySource {
 public:
  void configure(const WheelOdometryConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void set(const OdometrySample& sample) { input_ = sample; }
  Status execute() override;
  const std::optional<Motion>& motion() const override { return motion_; }
  Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(input_, last_, ahead_, suspect_, coasting_, usual_, has_twist_, odometry_pose_, motion_,
            next_sequence_, counters_);
  }

 private:
  /// True for the first stamp of a jump ahead: one message that is stamped wrongly must not make
  /// the rest late.
  bool isDoubtful();
  Status reject(const std::string& reason, const std::string& sentence);
  void beginAnew();
  Status changeFrames();
  Status followPose();
  Status followTwist();
  /// A pose that the robot cannot have reached from the last one.
  bool isSuspect(const OdometrySample& sample) const;
  bool followsPoses(const OdometrySample& sample) const;
  double shareFrom(const OdometrySample& sample) const;
  Status crossJump();
  void take(const Motion& motion);
  Motion motionBetween(const OdometrySample& from, const OdometrySample& to,
                       const Pose2& measured) const;
  /// From the last sample to this one, by the twist or the last velocity.
  Motion unmeasuredTo(const OdometrySample& sample) const;
  Pose2 calibrated(const Pose2& increment) const;
  Eigen::Matrix3d covarianceOf(const Pose2& increment, const OdometrySample& from,
                               Duration interval) const;

  WheelOdometryConfig config_;
  std::unique_ptr<MotionModel> model_;
  SpeedLimit limit_;
  OdometrySample input_;
  std::optional<OdometrySample> last_;
  std::optional<OdometrySample> ahead_;    ///< whose stamp jumped ahead and waits for another
  std::optional<OdometrySample> suspect_;  ///< whose pose waits for the next one
  Coasting coasting_;
  UsualInterval usual_;
  bool has_twist_ = false;  ///< the driver tells them
  Pose2 odometry_pose_;     ///< T_odom_base at last_
  std::optional<Motion> motion_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::wheel_odometry
