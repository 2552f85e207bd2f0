// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/run_metrics.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "slam_core/contract/grid_mapper.hpp"

namespace slam_ros {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// [MB]. The kernel's VmHWM: unlike ru_maxrss it does not begin with the peak of the process that
/// called this program. 0 where it is not to be had.
double peakMemory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kibibytes = 0.0;
  while (status >> word)
    if (word == "VmHWM:") status >> kibibytes;
  return kibibytes * 1024 / 1e6;
}

}  // namespace

double percentile(std::vector<double> values, double share) {
  if (values.empty()) throw std::invalid_argument("a percentile of no values");
  std::sort(values.begin(), values.end());
  const double rank = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(rank));
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - std::floor(rank)) * (values[above] - values[below]);
}

std::optional<double> meanEntropy(const slam::OccupancyGrid& grid) {
  double sum = 0.0;
  std::size_t known = 0;
  for (const auto cell : grid.cells) {
    if (cell == slam::OccupancyGrid::kUnknown) continue;
    const double p = cell / 100.0, q = 1.0 - p;
    if (p > 0.0 && q > 0.0) sum -= p * std::log2(p) + q * std::log2(q);
    ++known;
  }
  if (known == 0) return std::nullopt;
  return sum / static_cast<double>(known);
}

void AlarmTime::add(slam::Stamp stamp, bool holds) {
  if (held_ && stamp > last_) time_ += stamp - last_;
  if (holds && !held_) {
    ++alarms_;
    if (!first_) first_ = slam::seconds(stamp - start_);
  }
  held_ = holds;
  last_ = std::max(last_, stamp);
}

double AlarmTime::share() const {
  return last_ > start_ ? slam::seconds(time_) / slam::seconds(last_ - start_) : 0.0;
}

void RunMetrics::addTrust(slam::Stamp stamp, slam::Trust trust) {
  if (trust == slam::Trust::kUnknown && !lost_) return;
  if (!lost_) lost_.emplace(stamp);
  if (!doubtful_) doubtful_.emplace(stamp);
  lost_->add(stamp, trust == slam::Trust::kLost);
  doubtful_->add(stamp, trust == slam::Trust::kDoubtful);
}

void RunMetrics::addEvents(const slam::StepReport& report) {
  events_ += report.events.size();
  if (report.correction)
    largest_jump_ = std::max(largest_jump_.value_or(0.0), report.correction->distance);
}

double RunMetrics::wallSeconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void RunMetrics::addLatency(slam::Stamp stamp, Clock::duration time) {
  if (const auto found = front_end_.find(stamp); found != front_end_.end()) time += found->second;
  front_end_.erase(front_end_.begin(), front_end_.upper_bound(stamp));
  latency_ms_.push_back(std::chrono::duration<double, std::milli>(time).count());
}

std::string RunMetrics::toJson(slam::Duration data_time, std::uint64_t dropped_messages) const {
  rusage usage{}, of_children{};
  getrusage(RUSAGE_SELF, &usage);
  getrusage(RUSAGE_CHILDREN, &of_children);  // they read the bag
  const double wall = wallSeconds();
  nlohmann::ordered_json metrics;
  metrics["updates"] = updates();
  if (!update_ms_.empty()) {
    metrics["update_ms_p50"] = percentile(update_ms_, 0.5);
    metrics["update_ms_p99"] = percentile(update_ms_, 0.99);
  }
  if (!latency_ms_.empty()) {
    metrics["latency_ms_p50"] = percentile(latency_ms_, 0.5);
    metrics["latency_ms_p99"] = percentile(latency_ms_, 0.99);
  }
  if (map_entropy_) metrics["map_entropy_bits"] = *map_entropy_;
  if (lost_) {
    metrics["lost_alarms"] = lost_->alarms();
    if (lost_->first()) metrics["lost_first_s"] = *lost_->first();
    metrics["lost_share_of_time"] = lost_->share();
    metrics["doubtful_share_of_time"] = doubtful_->share();
  }
  metrics["events"] = events_;
  if (largest_jump_) metrics["largest_jump_m"] = *largest_jump_;
  metrics["cpu_s"] = seconds(usage.ru_utime) + seconds(usage.ru_stime) +
                     seconds(of_children.ru_utime) + seconds(of_children.ru_stime);
  metrics["wall_s"] = wall;
  if (wall > 0) metrics["realtime_factor"] = slam::seconds(data_time) / wall;
  if (const double peak = peakMemory(); peak > 0) metrics["max_rss_mb"] = peak;
  metrics["dropped_messages"] = dropped_messages;
  return metrics.dump(2) + "\n";
}

void RunMetrics::setGrid(const slam::Capabilities& backend) {
  const auto* mapper = backend.find<slam::GridMapper>();
  const auto grid = mapper == nullptr ? std::nullopt : mapper->grid();
  if (grid) setGrid(*grid);
}

}  // namespace slam_ros
