// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <deque>

namespace slam_ros {

/// Rate and latency of the last hundred messages, by the wall.
class LatencyWindow {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kSize = 100;

  /// A message that came at `begin` was done with at `end`.
  void add(Clock::time_point begin, Clock::time_point end);

  bool empty() const { return latencies_.empty(); }
  double rate() const;                      ///< [1/s]; 0 before the second message
  double milliseconds(double share) const;  ///< the latency that `share` of the messages kept

 private:
  std::deque<Clock::time_point> ends_;
  std::deque<double> latencies_;  ///< [ms]
};

}  // namespace slam_ros
