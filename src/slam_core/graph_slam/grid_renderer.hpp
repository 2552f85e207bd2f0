// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "slam_core/graph_slam/grid_drawing.hpp"
#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/submap.hpp"
#include "slam_core/grid_map/grid_map_config.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam::graph_slam {

/// The whole grid, drawn of the scans of all nodes where the graph has them. A scan keeps its
/// place in the drawing until its node has moved by half a cell; then the tiles that it touches are
/// drawn again. What is drawn does not depend on when it is asked for.
class GridRenderer {
 public:
  explicit GridRenderer(const grid_map::GridMapConfig& config);

  /// Scans are drawn into this grid.
  void startWith(const OccupancyGrid& grid);
  void add(graph::Key node, const Pose2& pose, const SharedScan& scan);
  /// Removes the scan of a node.
  void remove(graph::Key node);
  /// Takes over where the graph has the nodes now.
  void follow(const graph::Optimizer& graph);
  /// Without cells before the first scan or grid.
  OccupancyGrid grid() const;
  std::uint64_t revision() const { return revision_; }
  /// The memory of the scans, and the most that a drawing of them takes: it must not matter whether
  /// somebody has asked for one.
  double mostBytes() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(base_, scans_, scan_bytes_, covered_.min(), covered_.max(), revision_);
    if constexpr (Archive::kReads) {
      drawing_.reset();
      drawn_.clear();
      is_erased_ = false;
    }
  }

 private:
  friend struct SessionParts;  // writes and reads its members

  struct Scan {
    graph::Key node;
    Pose2 pose;  ///< as it is to be drawn
    SharedScan scan;
    double reach;  ///< no cell that it writes to is further from the robot [m]

    template <class Archive>
    void persist(Archive& archive) {
      archive(node, pose, scan, reach);
    }
  };
  double reachOf(const LaserScan& scan) const;
  grid_map::ScanPoints pointsOf(const Scan& scan) const;
  bool redrawMoved() const;
  void draw() const;
  void cover(const Scan& scan);

  grid_map::GridMapConfig config_;
  grid_map::BeamModel model_;
  std::optional<OccupancyGrid> base_;
  std::vector<Scan> scans_;
  double scan_bytes_ = 0.0;
  Eigen::AlignedBox2d covered_;  ///< by all scans so far [m]
  std::uint64_t revision_ = 1;
  /// The drawing holds the first scans at these poses, those of when somebody last asked for it.
  mutable std::unique_ptr<GridDrawing> drawing_;
  mutable std::vector<Pose2> drawn_;
  mutable bool is_erased_ = false;  ///< a scan that has gone
};

}  // namespace slam::graph_slam
