// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "slam_core/graph/quadratic_factor.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::graph_slam {

/// What a laser has seen on some metres of the way, drawn in the odometry frame of the scans: a
/// rigid piece of the map that hangs on its first node.
struct Submap {
  std::unique_ptr<scan_matching::ScanMap> map;
  graph::Key origin = -1;     ///< the node of its first scan
  Pose2 T_odom_origin;        ///< where that was drawn
  std::vector<Pose2> places;  ///< T_odom_base of its scans, or where a robot could have been
  double ended = 0.0;         ///< the way that had been gone with its last scan [m]

  bool isEmpty() const { return map->isEmpty(); }
};

/// The submaps of a path. Two are drawn at a time, begun in turn: scans are matched with the older
/// one, so that it always holds at least the given way, until it is finished (Hess et al. 2016).
class Submaps {
 public:
  /// @param way of a submap [m]
  Submaps(const grid_map::GridMapConfig& config, double way);

  /// To match with.
  const Submap& current() const { return older_; }
  const std::vector<Submap>& finished() const { return finished_; }
  /// This one, to begin with.
  void startWith(Submap submap) { older_ = std::move(submap); }
  /// @param node of the scan @param pose T_odom_base
  void insert(const scan_matching::ScanLevels& scan, graph::Key node, const Pose2& pose);
  /// That has been gone with the last scan [m].
  double way() const { return gone_; }
  double bytes() const;

 private:
  void add(const scan_matching::ScanLevels& scan, graph::Key node, const Pose2& pose,
           Submap& submap) const;

  grid_map::GridMapConfig config_;
  double way_;
  std::vector<Submap> finished_;
  Submap older_, younger_;
  double gone_ = 0.0, renewed_ = 0.0;  ///< [m]
  Pose2 last_;
};

}  // namespace slam::graph_slam
