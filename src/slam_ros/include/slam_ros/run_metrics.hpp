// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"

namespace slam_ros {

/// The value below which `share` (in [0, 1]) of the values lie, interpolated between neighbours.
/// @throw std::invalid_argument when there is no value
double percentile(std::vector<double> values, double share);

/// What a run cost, for metrics.json.
class RunMetrics {
 public:
  using Clock = std::chrono::steady_clock;

  /// The run began at `start`.
  explicit RunMetrics(Clock::time_point start = Clock::now()) : start_(start) {}

  void addUpdate(Clock::duration time) {
    update_ms_.push_back(std::chrono::duration<double, std::milli>(time).count());
  }
  std::size_t updates() const { return update_ms_.size(); }
  double wallSeconds() const;

  /// The metrics up to now, of this process. Keys without a value are absent.
  /// @param data_time what the data cover
  std::string toJson(slam::Duration data_time, std::uint64_t dropped_messages) const;

 private:
  Clock::time_point start_;
  std::vector<double> update_ms_;
};

}  // namespace slam_ros
