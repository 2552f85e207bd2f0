// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "decision_markers.hpp"

#include <algorithm>
#include <string>

#include "slam_ros/conversions.hpp"

namespace slam_active {
namespace {

using slam::active_path::Goal;
using visualization_msgs::Marker;

constexpr double kGoalLength = 0.6;                 // [m]
constexpr double kShortest = 0.15, kLongest = 0.5;  // of a candidate's arrow [m]
constexpr double kHeight = 0.05;                    // above the map [m]
constexpr double kLongestRate = 10.0;               // [bit m^2/m]

Marker marker(const std_msgs::Header& header, const std::string& kind, int type) {
  Marker message;
  message.header = header;
  message.ns = kind;
  message.type = type;
  message.action = Marker::ADD;
  message.pose.orientation.w = 1.0;
  message.color.a = 1.0F;
  return message;
}

Marker arrow(const std_msgs::Header& header, const std::string& kind, const Goal& goal,
             double length) {
  auto message = marker(header, kind, Marker::ARROW);
  message.pose = slam_ros::toSpatialMsg(goal.pose);
  message.pose.position.z = kHeight;
  message.scale.x = length;
  message.scale.y = message.scale.z = 0.2 * length;
  return message;
}

Marker clearing(const std_msgs::Header& header) {
  auto message = marker(header, "", Marker::ARROW);
  message.action = Marker::DELETEALL;
  return message;
}

Marker frontiers(const slam::active_path::Decision& decision, double resolution,
                 const std_msgs::Header& header) {
  auto message = marker(header, "frontiers", Marker::POINTS);
  message.scale.x = message.scale.y = resolution;
  message.color.b = 1.0F;
  message.color.g = 0.4F;
  for (const auto& place : decision.frontiers) {
    auto& point = message.points.emplace_back();
    point.x = place.x();
    point.y = place.y();
    point.z = kHeight;
  }
  return message;
}

Marker candidate(const std_msgs::Header& header, const Goal& goal, int id) {
  const double rate = goal.gain / std::max(goal.cost, kShortest);
  const double share = std::min(rate / kLongestRate, 1.0);
  auto message = arrow(header, "candidates", goal, kShortest + share * (kLongest - kShortest));
  message.id = id;
  message.color.r = message.color.g = message.color.b = 0.4F;
  return message;
}

Marker chosen(const std_msgs::Header& header, const Goal& goal) {
  auto message = arrow(header, "goal", goal, kGoalLength);
  message.color.r = goal.closes_loop ? 1.0F : 0.1F;
  message.color.g = goal.closes_loop ? 0.55F : 0.7F;
  return message;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const slam::active_path::Decision& decision,
                                          double resolution, const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  array.markers.push_back(clearing(header));
  if (!decision.frontiers.empty()) array.markers.push_back(frontiers(decision, resolution, header));
  for (std::size_t i = 0; i < decision.candidates.size(); ++i)
    array.markers.push_back(candidate(header, decision.candidates[i], static_cast<int>(i)));
  if (decision.goal) array.markers.push_back(chosen(header, *decision.goal));
  return array;
}

}  // namespace slam_active
