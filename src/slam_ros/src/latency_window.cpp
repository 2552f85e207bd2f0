// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/latency_window.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slam_ros {

void LatencyWindow::add(Clock::time_point begin, Clock::time_point end) {
  ends_.push_back(end);
  latencies_.push_back(std::chrono::duration<double, std::milli>(end - begin).count());
  if (ends_.size() <= kSize) return;
  ends_.pop_front();
  latencies_.pop_front();
}

double LatencyWindow::rate() const {
  if (ends_.size() < 2 || ends_.back() == ends_.front()) return 0.0;
  const std::chrono::duration<double> time = ends_.back() - ends_.front();
  return static_cast<double>(ends_.size() - 1) / time.count();
}

double LatencyWindow::milliseconds(double share) const {
  if (latencies_.empty()) return 0.0;
  std::vector<double> sorted(latencies_.begin(), latencies_.end());
  std::sort(sorted.begin(), sorted.end());
  const auto rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace slam_ros
