// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/Progress.h>

#include <functional>
#include <string>

#include "slam_core/common/settings.hpp"
#include "slam_core/laser/scan_gate.hpp"
#include "slam_core/point_map/point_map.hpp"
#include "slam_ros/clock_watch.hpp"

namespace slam_pointmap {

/// The point map with its entrance: takes what comes, in any order, and has the map do what is due.
class MapFeed {
 public:
  /// What there is to say of what came on a topic.
  using Report = std::function<void(const std::string& topic, const slam::Status& status)>;

  /// @throw slam::ConfigError
  void configure(slam::Settings& settings, Report report);
  void reset();

  /// Of a laser: a sweep or its mount.
  void takeSweep(const slam::LaserSweep& sweep, const std::string& topic);
  void takeMount(const slam::LaserMount& mount, const std::string& topic);
  /// Motion or a back-end's pose.
  template <class Input>
  void take(const Input& input, const std::string& topic) {
    checkClock();
    map_.set(input);
    update(topic);
  }

  const slam::point_map::PointMap& map() const { return map_; }
  slam::Counters counters() const;
  slam_msgs::Progress progress() const;

 private:
  void checkClock();
  void takeScans(const std::string& topic);
  void update(const std::string& topic);

  Report report_;
  slam::ScanGate gate_;
  slam::point_map::PointMap map_;
  slam_ros::ClockWatch clock_;
  slam::Stamp last_scan_;  ///< that has come, whether or not it could be used
};

}  // namespace slam_pointmap
