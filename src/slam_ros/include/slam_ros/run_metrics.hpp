// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/models/occupancy_grid.hpp"
#include "slam_core/product/step_report.hpp"

namespace slam_ros {

/// The value below which `share` (in [0, 1]) of the values lie, interpolated between neighbours.
/// @throw std::invalid_argument if there is no value
double percentile(std::vector<double> values, double share);

/// Mean entropy of a grid's known cells [bit]: 0 if all are certain, 1 if none is. Nothing for a
/// grid without known cells.
std::optional<double> meanEntropy(const slam::OccupancyGrid& grid);

/// When a condition held: that the robot was lost, or that its pose was in doubt.
class AlarmTime {
 public:
  explicit AlarmTime(slam::Stamp start) : start_(start), last_(start) {}
  void add(slam::Stamp stamp, bool holds);

  std::size_t alarms() const { return alarms_; }
  /// The time of the first alarm, since the first step [s]; nothing without one.
  std::optional<double> first() const { return first_; }
  /// The share of the time of all steps.
  double share() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(start_, last_, time_, alarms_, held_, first_);
  }

 private:
  slam::Stamp start_, last_;
  slam::Duration time_{};
  std::size_t alarms_ = 0;
  bool held_ = false;
  std::optional<double> first_;
};

/// What a run cost, and what the run itself knows about its grid map, for metrics.json.
class RunMetrics {
 public:
  using Clock = std::chrono::steady_clock;

  /// The run began at `start`.
  explicit RunMetrics(Clock::time_point start = Clock::now()) : start_(start) {}

  void addUpdate(Clock::duration time) {
    update_ms_.push_back(std::chrono::duration<double, std::milli>(time).count());
  }
  std::size_t updates() const { return update_ms_.size(); }
  /// Notes how far the pose can be relied on after the step of this stamp.
  void addTrust(slam::Stamp stamp, slam::Trust trust);
  /// The share of the time in which the pose was in doubt, but not lost.
  double doubtfulShare() const { return doubtful_ ? doubtful_->share() : 0.0; }
  /// Counts the events of a step and notes how far it moved the pose.
  void addEvents(const slam::StepReport& report);
  /// Adds the time for preparing the trigger of a step of this stamp, such as an image or a scan.
  void addFrontEnd(slam::Stamp stamp, Clock::duration time) { front_end_[stamp] += time; }
  /// Adds the back-end's time for the step of this stamp, to which addFrontEnd() has added before.
  void addLatency(slam::Stamp stamp, Clock::duration time);
  /// Notes the map at the end.
  void setGrid(const slam::OccupancyGrid& grid) { map_entropy_ = meanEntropy(grid); }
  /// The same for a back-end that makes one.
  void setGrid(const slam::Capabilities& backend);
  double wallSeconds() const;

  /// The metrics up to now, of this process. Keys without a value are absent.
  /// @param data_time the time that the data cover
  std::string toJson(slam::Duration data_time, std::uint64_t dropped_messages) const;

  /// The metrics of a resumed run cover all its parts, except for wall_s and cpu_s.
  template <class Archive>
  void persist(Archive& archive) {
    archive(update_ms_, latency_ms_, front_end_, events_, largest_jump_);
    const auto make = [] { return AlarmTime(slam::Stamp()); };
    archive.made(lost_, make);
    archive.made(doubtful_, make);
  }

 private:
  Clock::time_point start_;
  std::vector<double> update_ms_, latency_ms_;
  std::map<slam::Stamp, Clock::duration> front_end_;
  std::optional<double> map_entropy_;
  std::optional<AlarmTime> lost_, doubtful_;
  std::size_t events_ = 0;
  std::optional<double> largest_jump_;  ///< [m]
};

}  // namespace slam_ros
