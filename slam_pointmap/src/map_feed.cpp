// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "map_feed.hpp"

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_pointmap {

void MapFeed::configure(slam::Settings& settings, Report report) {
  report_ = std::move(report);
  gate_.configure(settings.read<slam::LaserConfig>());
  map_.configure(settings);
}

void MapFeed::reset() {
  gate_.reset();
  map_.reset();
}

void MapFeed::takeSweep(const slam::LaserSweep& sweep, const std::string& topic) {
  last_scan_ = sweep.stamp;
  checkClock();
  gate_.set(sweep);
  takeScans(topic);
}

void MapFeed::takeMount(const slam::LaserMount& mount, const std::string& topic) {
  checkClock();
  gate_.set(mount);
  takeScans(topic);
}

void MapFeed::takeScans(const std::string& topic) {
  const auto& scan = gate_.scan();
  do {
    report_(topic, gate_.next());
    if (scan) map_.set(*scan);
  } while (scan);
  update(topic);
}

void MapFeed::update(const std::string& topic) {
  do report_(topic, map_.execute());
  while (map_.isBusy());
}

void MapFeed::checkClock() {
  if (clock_.hasJumpedBack()) reset();
}

slam::Counters MapFeed::counters() const {
  auto all = map_.counters();
  for (const auto& [reason, count] : gate_.counters().all()) all.add("laser_" + reason, count);
  return all;
}

slam_msgs::Progress MapFeed::progress() const {
  slam_msgs::Progress message;
  message.motion = slam_ros::toRos(map_.lastMotion().value_or(slam::Stamp()));
  message.step = slam_ros::toRos(map_.lastPose().value_or(slam::Stamp()));
  message.scans = slam_ros::toRos(last_scan_);
  return message;
}

}  // namespace slam_pointmap
