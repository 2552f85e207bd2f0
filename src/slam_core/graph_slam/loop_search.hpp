// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/submaps.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::graph_slam {

/// A scan that was recognised in a submap. It joins the robot to the node at which the submap's
/// nearest scan was taken, so that it does not claim to know the way between the submap's nodes.
struct LoopClosure {
  graph::Key node = -1;
  Pose2 node_robot;            ///< T_node_base
  Eigen::Matrix3d covariance;  ///< of a twist of the robot
  bool was_searched = false;   ///< too far from where the graph had it for a local match
};

/// The covariance of a twist of the robot where a scan was recognised in a map.
/// @param drift variance of the part of the map around it, of (x, y, theta)
Eigen::Matrix3d covarianceOf(const scan_matching::Match& match, const Eigen::Vector3d& drift);

/// Looks for the robot in the submaps of long ago that may lie around it: how far from where the
/// graph has it, its covariance says.
class LoopSearch {
 public:
  /// @param way a submap counts as long ago that was finished so long a way before [m]
  /// @param variance_per_metre by which a submap errs, of (x, y, theta), for each metre of the way
  LoopSearch(const scan_matching::MatcherConfig& matcher, double way,
             const Eigen::Vector3d& variance_per_metre)
      : config_(matcher), matcher_(matcher), way_(way), variance_per_metre_(variance_per_metre) {}

  /// @param path whose last node is that of the scan
  std::vector<LoopClosure> find(const scan_matching::ScanLevels& scan, const PathGraph& path,
                                Submaps& submaps) const;

 private:
  /// What the graph knows of the robot in a submap before the scan is looked at.
  struct Candidate {
    std::size_t submap;
    Pose2 origin_node;
    Eigen::Matrix3d covariance;  ///< of a twist of the node
    double distance;             ///< to the nearest scan of the submap [m]
  };
  std::optional<Candidate> candidate(std::size_t number, const PathGraph& path,
                                     const Submap& submap) const;
  std::optional<LoopClosure> closure(const Candidate& candidate, Submaps& submaps,
                                     const scan_matching::ScanLevels& scan) const;

  scan_matching::MatcherConfig config_;
  scan_matching::ScanToMapMatcher matcher_;
  double way_;
  Eigen::Vector3d variance_per_metre_;
};

}  // namespace slam::graph_slam
