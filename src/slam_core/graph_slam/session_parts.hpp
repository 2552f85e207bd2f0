// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/path_record.hpp"
#include "slam_core/graph_slam/scan_graph.hpp"
#include "slam_core/graph_slam/session_graph.hpp"

namespace slam::graph_slam {

/// The numbers of scans in a session, by their addresses; looked up only.
using ScanNumbers = std::unordered_map<const LaserScan*, Session::Index>;

/// SessionParts writes each part of the back-end into a session and reads it from there. It is a
/// friend of these parts, so that nobody else sees what they keep. The path is read first, since it
/// builds the graph.
struct SessionParts {
  static SessionNumbers numbersOf(const PathGraph& path, const LandmarkGraph& landmarks,
                                  const std::vector<graph::RobustLoops::State>& loops) {
    return {path.graph(), landmarks.keys_, loops};
  }

  static void write(const PathGraph& path, const SessionNumbers& numbers, Session& session);
  static void write(const LandmarkGraph& landmarks, const SessionNumbers& numbers,
                    Session& session);
  static void write(const PathRecord& record, const SessionNumbers& numbers, Session& session);
  static void write(const ScanGraph& scans, const SessionNumbers& numbers, Session& session);

  static void read(const Session& session, PathGraph& path);
  static void read(const Session& session, LandmarkGraph& landmarks);
  static void read(const Session& session, PathRecord& record);
  /// @return a warning or error of the grid that the session began with, as ScanGraph::load()
  static Status read(const Session& session, ScanGraph& scans);

 private:
  /// Its nodes count as if they had just come.
  static void read(const Session& session, NodeChain& chain);
  static void write(const NodeChain& chain, const SessionNumbers& numbers, Session& session);
  static void write(const ScanPath& path, const SessionNumbers& numbers, Session& session);
  static void read(const Session& session, ScanPath& path);
  static void write(const GridRenderer& renderer, const SessionNumbers& numbers, Session& session);
  static void write(const Submaps& submaps, const SessionNumbers& numbers, const ScanNumbers& scans,
                    Session& session);
  static void read(const Session& session, GridRenderer& renderer);
  /// @param base the session's loaded grid, where it has one
  static void read(const Session& session, std::unique_ptr<scan_matching::ScanMap> base,
                   Submaps& submaps);
};

}  // namespace slam::graph_slam
