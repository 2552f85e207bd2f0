// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/odometry_anchor.hpp"

#include "slam_core/geometry/covariance.hpp"

namespace slam::mono_graph {
namespace {

/// @param increment independent of the pose
PosePrior composed(const PosePrior& pose, const PosePrior& increment) {
  Eigen::Matrix3d J_pose, J_increment;
  const Pose2 result = pose.pose.compose(increment.pose, &J_pose, &J_increment);
  return {result, symmetric(J_pose * pose.covariance * J_pose.transpose() +
                            J_increment * increment.covariance * J_increment.transpose())};
}

}  // namespace

void OdometryAnchor::place(const Pose2& pose, const Eigen::Matrix3d& covariance) {
  pose_ = pose;
  covariance_ = covariance;
  before_step_ = step_ = standing();
}

void OdometryAnchor::move(const Motion& motion) {
  step_ = composed(step_, {motion.increment, motion.covariance});
}

void OdometryAnchor::moveWith(const Pose2& before, const Pose2& after) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = after.rotation() * before.rotation().transpose();
  pose_ = after * before.between(pose_);
  covariance_ = symmetric(R * covariance_ * R.transpose());
}

void OdometryAnchor::beginStep() {
  before_step_ = since();
  step_ = standing();
}

PosePrior OdometryAnchor::since() const { return composed(before_step_, step_); }

PosePrior OdometryAnchor::predicted() const { return composed({pose_, covariance_}, since()); }

}  // namespace slam::mono_graph
