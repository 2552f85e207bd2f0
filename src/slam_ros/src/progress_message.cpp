// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/progress_message.hpp"

#include <algorithm>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

/// An input that has a field of its own.
struct Field {
  const char *input, *name;
  ros::Time slam_msgs::Progress::*stamp;
};
constexpr Field kInputFields[] = {
    {"motion", "motion", &slam_msgs::Progress::motion},
    {"observations", "observations", &slam_msgs::Progress::observations},
    {"scan", "scans", &slam_msgs::Progress::scans}};

const Field* fieldOf(const std::string& input) {
  const auto* found = std::find_if(std::begin(kInputFields), std::end(kInputFields),
                                   [&](const Field& field) { return field.input == input; });
  return found == std::end(kInputFields) ? nullptr : found;
}

}  // namespace

std::string progressName(const std::string& input) {
  const auto* field = fieldOf(input);
  return field != nullptr ? field->name : input;
}

void setProgress(slam_msgs::Progress& message, const std::string& input, slam::Stamp newest) {
  if (const auto* field = fieldOf(input); field != nullptr) {
    message.*field->stamp = toRos(newest);
    return;
  }
  message.inputs.push_back(input);
  message.newest.push_back(toRos(newest));
}

std::map<std::string, slam::Stamp> progressOf(const slam_msgs::Progress& message) {
  std::map<std::string, slam::Stamp> newest;
  for (const auto& field : kInputFields) newest[field.name] = fromRos(message.*field.stamp);
  for (std::size_t i = 0; i < std::min(message.inputs.size(), message.newest.size()); ++i)
    newest[message.inputs[i]] = fromRos(message.newest[i]);
  return newest;
}

}  // namespace slam_ros
