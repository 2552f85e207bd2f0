// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/markers.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/principal_axes.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

using visualization_msgs::Marker;

constexpr double kChiSquare95 = 5.991;   // two degrees of freedom
constexpr double kSmallestAxis = 0.02;   // [m], below it an ellipse could not be seen
constexpr double kPointDiameter = 0.08;  // [m]
constexpr double kLineWidth = 0.04;      // [m]
constexpr double kTextHeight = 0.25;     // [m]

std_msgs::ColorRGBA color(float r, float g, float b, float a) {
  std_msgs::ColorRGBA message;
  message.r = r;
  message.g = g;
  message.b = b;
  message.a = a;
  return message;
}

Marker marker(const std_msgs::Header& header, const std::string& kind,
              const slam::Landmark& landmark, int type) {
  Marker message;
  message.header = header;
  message.ns = kind;
  message.id = static_cast<int>(landmark.id);
  message.type = type;
  message.action = Marker::ADD;
  message.pose = toSpatialMsg({landmark.position.x(), landmark.position.y(), 0.0});
  return message;
}

Marker ellipse(const std_msgs::Header& header, const slam::Landmark& landmark) {
  auto message = marker(header, "ellipse", landmark, Marker::CYLINDER);
  const auto axes = slam::principalAxes(landmark.covariance);
  const auto diameter = [&](int axis) {
    const double variance = std::max(axes.values[axis], 0.0);
    return std::max(2.0 * std::sqrt(kChiSquare95 * variance), kSmallestAxis);
  };
  const Eigen::Vector2d major = axes.directions.col(1);
  message.pose = toSpatialMsg(
      {landmark.position.x(), landmark.position.y(), std::atan2(major.y(), major.x())});
  message.scale.x = diameter(1);
  message.scale.y = diameter(0);
  message.scale.z = 0.01;
  message.color = color(0.9F, 0.45F, 0.1F, 0.45F);
  return message;
}

Marker point(const std_msgs::Header& header, const slam::Landmark& landmark) {
  auto message = marker(header, "landmark", landmark, Marker::CYLINDER);
  message.scale.x = message.scale.y = kPointDiameter;
  message.scale.z = 0.02;
  message.color = color(0.75F, 0.15F, 0.05F, 1.0F);
  return message;
}

Marker text(const std_msgs::Header& header, const slam::Landmark& landmark) {
  auto message = marker(header, "id", landmark, Marker::TEXT_VIEW_FACING);
  message.pose.position.x += kPointDiameter;
  message.pose.position.y += kTextHeight;
  message.pose.position.z = 0.1;
  message.scale.z = kTextHeight;
  message.color = color(0.1F, 0.1F, 0.1F, 1.0F);
  message.text = std::to_string(landmark.id);
  return message;
}

Marker clearing(const std_msgs::Header& header) {
  Marker message;
  message.header = header;
  message.action = Marker::DELETEALL;
  message.pose.orientation.w = 1.0;
  return message;
}

/// The part of a wall that was seen.
Marker segment(const std_msgs::Header& header, const slam::Landmark& landmark) {
  auto message = marker(header, "landmark", landmark, Marker::LINE_LIST);
  message.pose =
      toSpatialMsg({landmark.position.x(), landmark.position.y(), landmark.direction + M_PI / 2.0});
  message.scale.x = kLineWidth;
  message.color = color(0.75F, 0.15F, 0.05F, 1.0F);
  for (const double place : {landmark.extent.begin, landmark.extent.end})
    message.points.emplace_back().x = place;
  return message;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const slam::LandmarkMap& landmarks,
                                          const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  array.markers.reserve(3 * landmarks.size());  // two of a line
  for (const auto& landmark : landmarks) {
    if (landmark.isLine()) {
      array.markers.push_back(segment(header, landmark));
    } else {
      array.markers.push_back(ellipse(header, landmark));
      array.markers.push_back(point(header, landmark));
    }
    array.markers.push_back(text(header, landmark));
  }
  return array;
}

visualization_msgs::MarkerArray LandmarkMarkers::next(const slam::LandmarkMap& landmarks,
                                                      const std_msgs::Header& header) {
  auto array = toMarkers(landmarks, header);
  Shown shown;
  shown.reserve(landmarks.size());
  for (const auto& landmark : landmarks) shown.emplace_back(landmark.id, landmark.kind);
  if (!shown_ || !std::includes(shown.begin(), shown.end(), shown_->begin(), shown_->end()))
    array.markers.insert(array.markers.begin(), clearing(header));
  shown_ = std::move(shown);
  return array;
}

}  // namespace slam_ros
