// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "slam_core/graph_slam/path_graph.hpp"
#include "slam_core/graph_slam/submap.hpp"
#include "slam_core/grid_map/grid_map_config.hpp"
#include "slam_core/models/occupancy_grid.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::graph_slam {

/// The whole grid, drawn of the scans of all nodes where the graph has them. A node's scan is drawn
/// again only where the node has moved by half a cell. What is drawn does not depend on when it is
/// asked for.
class GridRenderer {
 public:
  explicit GridRenderer(const grid_map::GridMapConfig& config);

  /// Scans are drawn into this grid.
  void startWith(const OccupancyGrid& grid);
  void add(graph::Key node, const Pose2& pose, const SharedScan& scan);
  /// Takes over where the graph has the nodes now.
  void follow(const graph::Optimizer& graph);
  /// Without cells before the first scan or grid.
  OccupancyGrid grid() const;
  std::uint64_t revision() const { return revision_; }
  std::size_t bytes() const;  ///< of scans and drawing

 private:
  struct Scan {
    graph::Key node;
    Pose2 pose;  ///< as it is to be drawn
    SharedScan scan;
  };
  void draw() const;

  grid_map::GridMapConfig config_;
  grid_map::BeamModel model_;
  std::optional<OccupancyGrid> base_;
  std::vector<Scan> scans_;
  std::uint64_t revision_ = 1;
  /// Of the first scans, as they were when it was asked for.
  mutable std::unique_ptr<scan_matching::ScanMap> drawing_;
  mutable std::size_t drawn_ = 0;
};

}  // namespace slam::graph_slam
