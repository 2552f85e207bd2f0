// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/camera/pose_fit.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::mono_graph {

/// A pose that is known, and odometry since then: what is expected of the pose now.
class OdometryAnchor {
 public:
  /// @param covariance of (x, y, theta), without what odometry adds to it
  void place(const Pose2& pose, const Eigen::Matrix3d& covariance);
  void move(const Motion& motion);
  /// Moves the anchor with the keyframe that it was tracked by, which was adjusted. Odometry since
  /// then stays as it is.
  /// @param before, after poses of the keyframe
  void moveWith(const Pose2& before, const Pose2& after);
  /// From here on odometry may be corrected. What it measured before this step stays as it is.
  void beginStep();
  /// The motion since the step began, or since the anchor was placed.
  const PosePrior& step() const { return step_; }
  void correctStep(const PosePrior& step) { step_ = step; }

  /// The anchor's pose with its covariance, and odometry since then with its own.
  PosePrior predicted() const;
  PosePrior since() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose_, covariance_, before_step_.pose, before_step_.covariance, step_.pose,
            step_.covariance);
  }

 private:
  static PosePrior standing() { return {Pose2(), Eigen::Matrix3d::Zero()}; }

  Pose2 pose_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  PosePrior before_step_ = standing(), step_ = standing();  ///< odometry
};

}  // namespace slam::mono_graph
