// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <deque>

namespace slam_ros {

/// Rate and latency of the last hundred messages, by the wall clock.
class LatencyWindow {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kSize = 100;

  /// Notes a message that came at `begin` and whose processing ended at `end`.
  void add(Clock::time_point begin, Clock::time_point end);

  bool empty() const { return latencies_.empty(); }
  double rate() const;                      ///< [1/s]; 0 before the second message
  double milliseconds(double share) const;  ///< not exceeded by `share` of the latencies

 private:
  std::deque<Clock::time_point> ends_;
  std::deque<double> latencies_;  ///< [ms]
};

}  // namespace slam_ros
