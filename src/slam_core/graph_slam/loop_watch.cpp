// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/loop_watch.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace slam::graph_slam {
namespace {

std::string loops(std::size_t count) {
  return count == 1 ? "1 loop" : std::to_string(count) + " loops";
}

}  // namespace

void LoopWatch::note(const graph::RobustLoops::Changes& now, const Pose2& before,
                     const Pose2& after) {
  const auto last = std::exchange(last_, now);
  const auto believed = now.believed - last.believed;
  const auto taken_back = now.taken_back - last.taken_back;
  const Pose2 moved = before.between(after);
  const auto add = [&](Event::Kind kind, std::string reason) {
    events_.push_back(
        {kind, moved.position().norm(), std::abs(moved.theta()), std::move(reason), {}});
  };
  if (believed > 0)
    add(Event::Kind::kLoopClosed,
        loops(believed) + " newly believed, " + loops(taken_back) + " taken back");
  else if (taken_back > 0)
    add(Event::Kind::kLoopTakenBack, loops(taken_back) + " taken back");
}

}  // namespace slam::graph_slam
