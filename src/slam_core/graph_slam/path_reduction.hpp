// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <unordered_set>
#include <utility>

#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/path_record.hpp"
#include "slam_core/graph_slam/place_raster.hpp"

namespace slam::graph_slam {

struct ReductionLimits {
  std::size_t nodes_per_place = 40;
  bool map_is_fixed = false;  ///< no node is kept for the map's sake
};

/// Keeps the graph as large as the area, not as long as the way (a reduced pose graph: Johannsson,
/// Kaess, Fallon, Leonard 2013). A node of some time ago is removed where enough older ones stand
/// near it and its landmarks have been seen often enough: its sightings go, and the motions
/// beside it become one, so that the path always hangs together. What is left out is information:
/// the graph never claims to know more than it does.
class PathReduction {
 public:
  /// @param path, landmarks, record outlive this
  PathReduction(const ReductionLimits& limits, PathGraph& path, LandmarkGraph& landmarks,
                PathRecord& record)
      : limits_(limits), path_(path), landmarks_(landmarks), record_(record) {}

  /// Removes what is to go by now; to be called after each step.
  void reduce();
  /// The nodes that there are stay for good, as those of a session.
  void keepAll();
  /// Nodes that must stay, whatever is seen from them, until they are released.
  void keepWhile(std::function<bool(graph::Key)> is_held) { is_held_ = std::move(is_held); }
  void release(graph::Key node);
  /// @param forget is called with each node that is about to be removed
  void announceTo(std::function<void(graph::Key)> forget) { forget_ = std::move(forget); }
  /// The number of nodes removed so far.
  std::size_t removed() const { return removed_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(places_, newest_, open_, window_, leaving_, to_keep_, removed_);
  }

 private:
  bool isToBeJudged(graph::Key node) const;
  void judge(graph::Key node);
  void settle(graph::Key node);
  bool isNew(graph::Key node) const;
  bool isKnown(std::size_t landmark) const;
  void remove(graph::Key node);
  void hangRecord(graph::Key node);
  void dropSightings(graph::Key node);

  ReductionLimits limits_;
  PathGraph& path_;
  LandmarkGraph& landmarks_;
  PathRecord& record_;
  std::function<bool(graph::Key)> is_held_ = [](graph::Key) { return false; };
  std::function<void(graph::Key)> forget_ = [](graph::Key) {};
  PlaceRaster places_;
  graph::Key newest_ = -1;
  std::unordered_set<graph::Key> open_;  ///< nodes of which it is not decided yet; looked up only
  std::deque<graph::Key> window_;        ///< nodes that stay because they are recent
  std::deque<graph::Key> leaving_;       ///< nodes to remove unless new ones follow at once
  std::size_t to_keep_ = 0;              ///< nodes after a new one that stay with it
  std::size_t removed_ = 0;
};

}  // namespace slam::graph_slam
