// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "slam_core/graph/robust_loops.hpp"
#include "slam_core/graph_slam/grid_renderer.hpp"
#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/submaps.hpp"

namespace slam::graph_slam {

/// Drops each submap that shows nothing new once it is finished: all its scans were taken near
/// older ones that stay, and scans were recognised there. Its scans, and the loops found with them,
/// go with it where no other submap holds them.
class ScanReduction {
 public:
  /// @param path, submaps, loops, renderer outlive this
  ScanReduction(PathGraph& path, Submaps& submaps, graph::RobustLoops& loops,
                GridRenderer& renderer)
      : path_(path), submaps_(submaps), loops_(loops), renderer_(renderer) {}

  /// Looks at the submap that was finished last; to be called after each scan that was inserted.
  void reduce();
  /// All submaps that are finished stay, as those of a session.
  void keepAll();
  /// The nodes whose scans have gone since the last call.
  std::vector<graph::Key> takeReleased() { return std::exchange(released_, {}); }
  /// Whether the node has a scan that stays for now.
  bool holds(graph::Key node) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(kept_, finished_, released_);
  }

 private:
  bool isKnown(const Submap& submap) const;
  bool isNearKept(graph::Key node) const;
  bool hasLoop(const Submap& submap) const;
  void keep(const Submap& submap);
  void drop();

  PathGraph& path_;
  Submaps& submaps_;
  graph::RobustLoops& loops_;
  GridRenderer& renderer_;
  std::vector<graph::Key> kept_;  ///< nodes of finished submaps, in order
  std::size_t finished_ = 0;      ///< submaps that stay
  std::vector<graph::Key> released_;
};

}  // namespace slam::graph_slam
