// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/camera/pose_fit.hpp"
#include "slam_core/mono_graph/point_search.hpp"

namespace slam::mono_graph {

/// It holds what an image shows of the map around the robot. A pose that odometry cannot have led
/// to is none: repeated patterns were taken for one another, and all matches are rejected.
struct TrackedView {
  Pose2 pose;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of the points, about (x, y, theta)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();   ///< with odometry; the map taken as exact
  std::vector<PointMatch> matches;                        ///< that fit the pose
  std::vector<PointMatch> rejected;                       ///< that do not
  std::vector<PointMatch> unfitted;                       ///< too few to fit a pose
  std::vector<int> expected;  ///< points that were to be seen from the pose
  double in_reach = 1.0;      ///< probability of a point to be where it was searched
};

/// Follows the camera through the map: looks for the points of nearby keyframes around where the
/// predicted pose projects them, fits the pose, and looks once more with it, nearer by.
TrackedView track(const VisualMap& map, const Features& features, const PosePrior& prior,
                  const std::vector<int>& keyframes);

/// The keyframe that sees most of the matched points, the older one of two; nothing without any.
std::optional<int> referenceOf(const VisualMap& map, const std::vector<PointMatch>& matches);
/// A keyframe with those that share points with it, and those before and after it.
std::vector<int> keyframesAround(const VisualMap& map, int keyframe);

std::vector<PoseSighting> sightingsOf(const VisualMap& map, const Features& features,
                                      const std::vector<PointMatch>& matches);

}  // namespace slam::mono_graph
