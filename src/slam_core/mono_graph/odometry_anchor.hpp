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
  /// The anchor itself lies elsewhere; odometry since then stays as it is.
  void moveAnchorTo(const Pose2& pose) { pose_ = pose; }
  /// The anchor's pose with its covariance, and odometry since then with its own.
  PosePrior predicted() const;
  const Pose2& since() const { return since_; }
  const Eigen::Matrix3d& covarianceSince() const { return covariance_since_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose_, covariance_, since_, covariance_since_);
  }

 private:
  Pose2 pose_, since_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d covariance_since_ = Eigen::Matrix3d::Zero();
};

}  // namespace slam::mono_graph
