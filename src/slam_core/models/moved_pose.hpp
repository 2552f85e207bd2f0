// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// @return the pose with its covariance after a motion whose errors are taken to be independent of
/// those of the pose (Smith, Self, Cheeseman 1990)
inline PoseEstimate moved(const PoseEstimate& robot, const Motion& motion) {
  Eigen::Matrix3d J_pose, J_motion;
  const Pose2 pose = robot.pose.compose(motion.increment, &J_pose, &J_motion);
  return {pose, symmetric(J_pose * robot.covariance * J_pose.transpose() +
                          J_motion * motion.covariance * J_motion.transpose())};
}

}  // namespace slam
