// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/grid_publisher.hpp"

#include <cmath>
#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

nav_msgs::OccupancyGrid toMsg(const slam::OccupancyGrid& grid, slam::Stamp stamp,
                              const std::string& frame) {
  nav_msgs::OccupancyGrid message;
  message.header.stamp = message.info.map_load_time = toRos(stamp);
  message.header.frame_id = frame;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = grid.width;
  message.info.height = grid.height;
  message.info.origin.position.x = grid.origin.x();
  message.info.origin.position.y = grid.origin.y();
  message.info.origin.orientation.w = 1.0;
  message.data = grid.cells;
  return message;
}

slam::OccupancyGrid fromMsg(const nav_msgs::OccupancyGrid& message) {
  slam::OccupancyGrid grid;
  grid.resolution = message.info.resolution;
  grid.origin = fromMsg(message.info.origin).position();
  grid.width = message.info.width;
  grid.height = message.info.height;
  grid.cells = message.data;
  return grid;
}

bool isTurned(const nav_msgs::OccupancyGrid& message) {
  const auto origin = fromMsg(message.info.origin);
  return !origin.isFinite() || std::abs(origin.theta()) > 1e-6;
}

GridPublisher::GridPublisher(ros::NodeHandle handle, const slam::GridMapper& mapper,
                             std::string map_frame, double period)
    : mapper_(mapper),
      map_frame_(std::move(map_frame)),
      map_(handle.advertise<nav_msgs::OccupancyGrid>("map", 1, true)),
      metadata_(handle.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true)),
      dynamic_(handle.advertiseService("dynamic_map", &GridPublisher::answer, this)),
      static_(handle.advertiseService("static_map", &GridPublisher::answer, this)),
      rate_(1.0 / period) {}

void GridPublisher::update(slam::Stamp stamp) {
  stamp_ = stamp;
  if (rate_.isDue(stamp)) flush();
}

void GridPublisher::flush() {
  const auto subscribers = map_.getNumSubscribers() + metadata_.getNumSubscribers();
  const bool has_changed = mapper_.gridRevision() != published_;
  if (subscribers > 0 && (has_changed || subscribers > subscribers_)) publish();
  subscribers_ = subscribers;
}

void GridPublisher::publish() {
  auto grid = mapper_.grid();
  if (!grid || grid->cells.empty()) return;
  const auto send = [this, grid = std::move(*grid), stamp = stamp_] {
    const auto message =
        boost::make_shared<const nav_msgs::OccupancyGrid>(toMsg(grid, stamp, map_frame_));
    metadata_.publish(message->info);
    map_.publish(message);
  };
  if (background_.tryRun(send)) published_ = mapper_.gridRevision();
}

bool GridPublisher::answer(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
  const auto grid = mapper_.grid();
  if (!grid) return false;
  response.map = toMsg(*grid, stamp_, map_frame_);
  return true;
}

}  // namespace slam_ros
