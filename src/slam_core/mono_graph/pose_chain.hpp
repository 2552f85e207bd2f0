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

/// One camera does not measure how far a pose is from a keyframe. Odometry around the keyframe
/// does. Its errors stay in the scale of the points for the length of some neighbourhoods, so that
/// they add up to more than those of odometry itself.
/// @return what that adds to the covariance of the pose (x, y, theta) in the map, the keyframe
/// taken as exact
Eigen::Matrix3d scaleCovariance(const VisualMap& map, int keyframe, const Pose2& pose);

/// It joins a keyframe with an earlier one.
struct Link {
  int earlier = 0;
  /// It is that of the keyframe's coordinates in the map frame where the earlier one is exact.
  Eigen::Matrix3d covariance;
  bool is_by_odometry = false;  ///< and by nothing else
};

/// Up to so many links to the earlier keyframes that share most points with this one; where there
/// are none that by odometry, if the keyframe has one.
std::vector<Link> linksOf(const VisualMap& map, int keyframe, std::size_t most);

/// The covariance of a keyframe's pose in the map: of the chains over keyframes that see the same
/// points, and over odometry, the one that leaves least. Chains are not fused, since points that
/// were seen from the same keyframes err together. Over links by odometry alone its errors count as
/// independent up to a metre, and beyond as correlated as they can be: wheels of slightly wrong
/// sizes err the same way in each piece (see slam::DeadReckoning, whose bound this is). Nothing
/// where no chain leads to the keyframe.
std::optional<ChainCovariance> chainedCovariance(const VisualMap& map, int keyframe);

}  // namespace slam::mono_graph
