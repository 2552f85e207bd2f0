// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "slam_core/models/motion.hpp"
#include "slam_core/models/turn.hpp"
#include "slam_core/visual_odometry/alignment.hpp"
#include "slam_core/visual_odometry/gap_motion.hpp"
#include "slam_core/visual_odometry/view.hpp"
#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// Makes the motions from view to view: where images were aligned, and across gaps in which they
/// tell nothing. What a gap has cost in certainty is undone, with its doubt, by the step out of it.
class IncrementMaker {
 public:
  void configure(const VisualOdometryConfig& config) { config_ = config; }
  /// Asked for the motion across gaps; without an answer the last velocity is taken.
  void setGapSource(GapSource source) { gap_source_ = std::move(source); }
  bool hasGapSource() const { return static_cast<bool>(gap_source_); }
  /// Asked for the turn where nothing but the last velocity is known.
  void setTurnSource(TurnSource source) { turn_source_ = std::move(source); }
  /// A sentence on what is used where images tell nothing.
  std::string instead() const;
  void reset();
  /// All is as after reset(), but the sequence goes on.
  void beginAnew();
  /// The present view is the reference of its own: nothing of a gap is taken back any more.
  void forgetGap() { gap_covariance_.setZero(); }

  /// To a view that was aligned with a reference at T_odom_reference. @param after_gap then it
  /// tells no velocity
  Motion follow(const View& last, const View& now, const Alignment& alignment,
                const Pose2& T_odom_reference, bool after_gap);
  /// To a view that tells nothing: sets where it is.
  Motion bridge(const View& last, View& now, Stamp gap_begin);

  /// Where the robot is if it goes on as it did at the view given.
  Pose2 expected(const View& from, Stamp stamp) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(velocity_, gap_covariance_, has_turn_, next_sequence_);
  }

 private:
  std::optional<Turn> turnBetween(Stamp start, Stamp end) const;
  GapMotion coast(Stamp start, Stamp end, Stamp gap_begin) const;
  Eigen::Matrix3d covarianceOf(const View& last, const View& now, const Eigen::Matrix3d& alignment,
                               const Pose2& T_odom_reference) const;
  Motion motionBetween(const View& last, const View& now, const Eigen::Matrix3d& covariance);

  VisualOdometryConfig config_;
  GapSource gap_source_;
  TurnSource turn_source_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();        ///< [m/s, m/s, rad/s]
  Eigen::Matrix3d gap_covariance_ = Eigen::Matrix3d::Zero();  ///< since the last good view
  bool has_turn_ = false;  ///< the turn source knew the turn of the last gap
  std::uint64_t next_sequence_ = 0;
};

}  // namespace slam::visual_odometry
