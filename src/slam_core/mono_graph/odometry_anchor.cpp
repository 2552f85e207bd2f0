// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/odometry_anchor.hpp"

#include "slam_core/geometry/covariance.hpp"

namespace slam::mono_graph {
namespace {

/// Of a pose and an increment that is independent of it.
PosePrior composed(const Pose2& pose, const Eigen::Matrix3d& covariance, const Pose2& increment,
                   const Eigen::Matrix3d& of_increment) {
  Eigen::Matrix3d J_pose, J_increment;
  const Pose2 result = pose.compose(increment, &J_pose, &J_increment);
  return {result, symmetric(J_pose * covariance * J_pose.transpose() +
                            J_increment * of_increment * J_increment.transpose())};
}

}  // namespace

void OdometryAnchor::place(const Pose2& pose, const Eigen::Matrix3d& covariance) {
  pose_ = pose;
  covariance_ = covariance;
  since_ = {};
  covariance_since_.setZero();
}

void OdometryAnchor::move(const Motion& motion) {
  const auto next = composed(since_, covariance_since_, motion.increment, motion.covariance);
  since_ = next.pose;
  covariance_since_ = next.covariance;
}

PosePrior OdometryAnchor::predicted() const {
  return composed(pose_, covariance_, since_, covariance_since_);
}

}  // namespace slam::mono_graph
