// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/mono_graph/visual_map.hpp"

namespace slam::mono_graph {

/// A point of the map and the feature of an image that was taken for it.
struct PointMatch {
  int point = 0;
  std::size_t feature = 0;
};

/// It holds what a search among the points of the map finds in an image.
struct PointMatches {
  std::vector<PointMatch> matches;  ///< each point and each feature at most once
  std::vector<int> expected;        ///< points that are to be seen from this pose
};

/// They bound a search around the pixel to which a pose projects a point.
struct SearchLimits {
  double radius = 8.0;        ///< [px]
  int largest_distance = 60;  ///< of descriptors
  double ratio = 0.85;        ///< of the best one's distance to the second one's
};

/// Looks for points of the map where a pose projects them (Mur-Artal et al. 2015, V.D): only those
/// that are seen from about where they were seen first, at about their size there.
PointMatches searchPoints(const VisualMap& map, const std::vector<int>& points,
                          const Features& features, const Pose2& pose, const SearchLimits& limits);

/// It tells how a point's feature would look from a pose; the level is a real number.
struct Appearance {
  Eigen::Vector2d seen;
  double level = 0.0;
};
/// @return nothing where the point cannot be seen from there
std::optional<Appearance> appearanceOf(const VisualMap& map, const MapPoint& point,
                                       const Features& features, const Pose2& pose);

}  // namespace slam::mono_graph
