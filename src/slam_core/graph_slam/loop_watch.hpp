// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/contract/event_reporter.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/robust_loops.hpp"

namespace slam::graph_slam {

/// Tells which loops a scan has made the graph believe or give up, and how far that moved the
/// robot.
class LoopWatch {
 public:
  /// Another scan has come.
  void begin() { events_.clear(); }
  /// @param now of all loops so far
  /// @param before the robot as the graph had it before the loops were judged
  /// @param after the same afterwards
  void note(const graph::RobustLoops::Changes& now, const Pose2& before, const Pose2& after);
  const std::vector<Event>& events() const { return events_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_, events_);
  }

 private:
  graph::RobustLoops::Changes last_;
  std::vector<Event> events_;
};

}  // namespace slam::graph_slam
