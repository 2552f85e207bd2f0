// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/points_publisher.hpp"

#include <cstring>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

constexpr double kFlushInterval = 0.5;  // [s] of the wall: stamps may stand still
constexpr const char* kFields[] = {"x", "y", "z", "intensity"};

const ModulePublisherRegistrar<slam::point_map::PointMap, PointsPublisher> kPointsPublisher;

}  // namespace

sensor_msgs::PointCloud2 toMsg(const std::vector<slam::point_map::MapPoint>& points,
                               slam::Stamp stamp, const std::string& frame) {
  sensor_msgs::PointCloud2 message;
  message.header.stamp = toRos(stamp);
  message.header.frame_id = frame;
  message.height = 1;
  message.width = static_cast<std::uint32_t>(points.size());
  for (const auto* name : kFields) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(message.fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    message.fields.push_back(field);
  }
  message.point_step = sizeof(float) * 4;
  message.row_step = message.point_step * message.width;
  message.is_dense = true;
  message.data.resize(message.row_step);
  auto* to = message.data.data();
  for (const auto& [position, count] : points) {
    const float values[] = {static_cast<float>(position.x()), static_cast<float>(position.y()),
                            0.0f, static_cast<float>(count)};
    std::memcpy(to, values, sizeof(values));
    to += sizeof(values);
  }
  return message;
}

PointsPublisher::PointsPublisher(const slam::point_map::PointMap& map, const Context& context)
    : map_(map), map_frame_(context.map_frame), rate_(context.rate) {
  auto handle = context.handle;
  points_ = handle.advertise<sensor_msgs::PointCloud2>("points", 1, true);
  flush_timer_ = handle.createWallTimer(ros::WallDuration(kFlushInterval),
                                        [this](const ros::WallTimerEvent&) { flush(); });
}

void PointsPublisher::update() {
  if (map_.revision() != published_ && rate_.isDue(map_.stamp())) flush();
}

void PointsPublisher::flush() {
  const auto subscribers = points_.getNumSubscribers();
  const bool has_changed = map_.revision() != published_;
  if (subscribers > 0 && (has_changed || subscribers > subscribers_)) publish();
  subscribers_ = subscribers;
}

void PointsPublisher::publish() {
  const auto send = [this, points = map_.points(), stamp = map_.stamp()] {
    points_.publish(
        boost::make_shared<const sensor_msgs::PointCloud2>(toMsg(points, stamp, map_frame_)));
  };
  if (background_.tryRun(send)) published_ = map_.revision();
}

}  // namespace slam_ros
