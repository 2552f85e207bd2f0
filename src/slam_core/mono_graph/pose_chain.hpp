// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/mono_graph/visual_map.hpp"

namespace slam::mono_graph {

/// The covariance of a pose that is known relative to another one.
/// @param of_origin that of the origin's pose in the map
/// @param of_pose that of the pose (x, y, theta) in the map, the origin taken as exact
Eigen::Matrix3d chained(const Pose2& origin, const Eigen::Matrix3d& of_origin, const Pose2& pose,
                        const Eigen::Matrix3d& of_pose);

/// What joins a keyframe with an earlier one.
struct Link {
  int earlier = 0;
  /// It is that of the keyframe's coordinates in the map frame where the earlier one is exact.
  Eigen::Matrix3d covariance;
};

/// Up to so many links to the earlier keyframes that share most points with this one; where there
/// are none that by odometry, if the keyframe has one.
std::vector<Link> linksOf(const VisualMap& map, int keyframe, std::size_t most);

/// The covariance of a keyframe's pose in the map: of the chains over keyframes that see the same
/// points, and over odometry, the one that leaves least. Chains are not fused, since points that
/// were seen from the same keyframes err together. Nothing where no chain leads to the keyframe.
std::optional<Eigen::Matrix3d> chainedCovariance(const VisualMap& map, int keyframe);

}  // namespace slam::mono_graph
