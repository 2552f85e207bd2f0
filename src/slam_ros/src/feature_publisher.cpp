// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/feature_publisher.hpp"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <utility>

#include "slam_ros/conversions.hpp"

namespace slam_ros {

sensor_msgs::PointCloud2 toMsg(const std::vector<slam::MappedFeature>& features, slam::Stamp stamp,
                               const std::string& frame) {
  sensor_msgs::PointCloud2 message;
  message.header.stamp = toRos(stamp);
  message.header.frame_id = frame;
  message.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(message);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(features.size());
  sensor_msgs::PointCloud2Iterator<float> coordinate(message, "x");
  for (const auto& feature : features) {
    for (int i = 0; i < 3; ++i) coordinate[i] = static_cast<float>(feature.position(i));
    ++coordinate;
  }
  return message;
}

FeaturePublisher::FeaturePublisher(ros::NodeHandle handle, const slam::FeatureMapper& mapper,
                                   std::string map_frame, double rate)
    : mapper_(mapper),
      map_frame_(std::move(map_frame)),
      features_(handle.advertise<sensor_msgs::PointCloud2>("features", 1)),
      rate_(rate) {}

void FeaturePublisher::update(slam::Stamp stamp) {
  if (features_.getNumSubscribers() == 0 || !rate_.isDue(stamp)) return;
  features_.publish(toMsg(mapper_.features(), stamp, map_frame_));
}

}  // namespace slam_ros
