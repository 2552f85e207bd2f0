// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/counters.hpp"
#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/graph/robust_loops.hpp"
#include "slam_core/graph_slam/graph_config.hpp"
#include "slam_core/graph_slam/grid_renderer.hpp"
#include "slam_core/graph_slam/loop_search.hpp"
#include "slam_core/graph_slam/loop_watch.hpp"
#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/scan_path.hpp"
#include "slam_core/graph_slam/scan_reduction.hpp"
#include "slam_core/graph_slam/submaps.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/scan_matching/scan_doubt.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"
#include "slam_core/scan_matching/scan_watch.hpp"

namespace slam::graph_slam {

/// The scans of a graph (Hess, Kohler, Rapp, Andor 2016): each scan is matched with the current
/// submap, which tells the motion since the last node; every few decimetres one becomes a node and
/// goes into the submaps, and is looked for in those of long ago.
class ScanGraph {
 public:
  /// @param path outlives this
  ScanGraph(PathGraph& path, const GraphConfig& config, const grid_map::GridMapConfig& grid,
            const scan_matching::MatcherConfig& matcher);

  /// The robot has been put there by something else than a scan.
  void restart(const PoseEstimate& robot);
  /// Scans are matched with this grid to begin with.
  /// @return a warning where not all of it is used, an error where none of it is
  Status load(const OccupancyGrid& grid);
  /// Motion since the last scan.
  void predict(const Motion& motion);
  Status take(const LaserScan& scan, Counters& counters);
  Status status() const;

  std::optional<OccupancyGrid> grid() const;
  std::uint64_t gridRevision() const { return renderer_.revision(); }
  const scan_matching::ScanDoubt& doubt() const { return doubt_; }
  const graph::RobustLoops& loops() const { return loops_; }
  /// The most memory that it takes; the same whether somebody has asked for the grid or not.
  double mostBytes() const { return static_cast<double>(submaps_.bytes()) + renderer_.mostBytes(); }
  /// What came of the loops with the last scan.
  friend const std::vector<Event>& eventsOf(const ScanGraph& scans) {
    return scans.loop_watch_.events();
  }
  /// The scan that became a node with the last take(); none where none did.
  friend const SharedScan& insertedBy(const ScanGraph& scans) { return scans.inserted_; }
  friend ScanReduction& reductionOf(ScanGraph& scans) { return scans.reduction_; }
  friend ScanPath& pathOf(ScanGraph& scans) { return scans.told_; }
  friend GraphView viewOf(const graph::Optimizer& graph, const ScanGraph* scans);

  template <class Archive>
  void persist(Archive& archive) {
    archive(told_, submaps_, loops_, loop_watch_, renderer_, reduction_, tracker_, trigger_, doubt_,
            watch_, inserted_);
  }

 private:
  friend struct SessionParts;  // writes and reads its members

  scan_matching::Match match(const scan_matching::ScanLevels& scan, Stamp stamp,
                             Counters& counters);
  Pose2 mapFromOdom() const;
  void correctPath(bool is_determined);
  Status insert(const LaserScan& scan, const scan_matching::ScanLevels& points,
                const scan_matching::Match& found, Counters& counters);
  void closeLoops(const scan_matching::ScanLevels& scan, graph::Key node, Counters& counters);

  PathGraph& path_;
  GraphConfig config_;
  grid_map::GridMapConfig grid_config_;
  Eigen::Vector3d drift_;  ///< variance for each metre
  ScanPath told_{path_, drift_, config_.iterations};
  scan_matching::LevelModels models_;
  double spacing_;
  Submaps submaps_;
  LoopSearch search_;
  graph::RobustLoops loops_;
  LoopWatch loop_watch_;
  GridRenderer renderer_;
  ScanReduction reduction_{path_, submaps_, loops_, renderer_};
  scan_matching::ScanTracker tracker_;
  scan_matching::InsertionTrigger trigger_;
  scan_matching::ScanDoubt doubt_;
  scan_matching::ScanWatch watch_;
  SharedScan inserted_;
};

}  // namespace slam::graph_slam
