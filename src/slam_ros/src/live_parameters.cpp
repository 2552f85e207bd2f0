// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/live_parameters.hpp"

#include <dynamic_reconfigure/ConfigDescription.h>
#include <ros/console.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace slam_ros {
namespace {

using dynamic_reconfigure::Config;

constexpr double kLargest = 1e9;           // of a bound: clients show a slider between the two
constexpr const char* kGroup = "Default";  // what clients call the group of all parameters

template <class Entries, class Value>
void append(Entries& entries, const std::string& name, Value value) {
  auto& entry = entries.emplace_back();
  entry.name = name;
  entry.value = value;
}

/// Adds a number under the name of a field, as the kind that the field has.
void append(Config& config, const slam::Field& field, double value) {
  if (std::holds_alternative<bool*>(field.target))
    append(config.bools, field.name, value != 0.0);
  else if (std::holds_alternative<int*>(field.target))
    append(config.ints, field.name, static_cast<int>(value));
  else
    append(config.doubles, field.name, value);
}

std::string typeOf(const slam::Field& field) {
  if (std::holds_alternative<bool*>(field.target)) return "bool";
  return std::holds_alternative<int*>(field.target) ? "int" : "double";
}

/// The value of a field that may be live.
double valueOf(const slam::Field& field) {
  if (const auto* flag = std::get_if<bool*>(&field.target)) return **flag ? 1.0 : 0.0;
  if (const auto* number = std::get_if<int*>(&field.target)) return **number;
  return *std::get<double*>(field.target);
}

/// Sets what is allowed; what is not keeps its value, with a warning.
template <class Value, class Entries>
bool assign(const std::vector<const slam::Field*>& fields, const Entries& entries) {
  bool has_changed = false;
  for (const auto& entry : entries) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto* candidate) {
      return candidate->name == entry.name && std::holds_alternative<Value*>(candidate->target);
    });
    if (field == fields.end()) continue;
    auto& value = *std::get<Value*>((*field)->target);
    const Value before = std::exchange(value, static_cast<Value>(entry.value));
    if (value == before) continue;
    if (const auto fault = (*field)->fault(); !fault.empty()) {
      value = before;
      ROS_WARN_STREAM_NAMED("slam", entry.name << " is not changed: " << fault);
    } else {
      has_changed = true;
    }
  }
  return has_changed;
}

void appendGroup(Config& config) {
  auto& group = config.groups.emplace_back();
  group.name = kGroup;
  group.state = true;
}

}  // namespace

void LiveParameters::start(ros::NodeHandle handle) {
  for (const auto& field : fields_.all())
    if (field.is_live) live_.push_back(&field);
  publishDescription(handle);
  updates_ = handle.advertise<Config>("parameter_updates", 1, true);
  updates_.publish(inForce());
  service_ = handle.advertiseService("set_parameters", &LiveParameters::set, this);
}

void LiveParameters::publishDescription(ros::NodeHandle& handle) {
  dynamic_reconfigure::ConfigDescription description;
  auto& group = description.groups.emplace_back();
  group.name = kGroup;
  for (const auto* field : live_) {
    auto& parameter = group.parameters.emplace_back();
    parameter.name = field->name;
    parameter.type = typeOf(*field);
    parameter.description =
        field->sentence + (field->unit_text.empty() ? "" : " [" + field->unit_text + "]");
    append(description.min, *field, std::max(field->range.min, -kLargest));
    append(description.max, *field, std::min(field->range.max, kLargest));
  }
  description.dflt = inForce();
  for (auto* config : {&description.min, &description.max}) appendGroup(*config);
  descriptions_ = handle.advertise<decltype(description)>("parameter_descriptions", 1, true);
  descriptions_.publish(description);
}

Config LiveParameters::inForce() const {
  Config config;
  for (const auto* field : live_) append(config, *field, valueOf(*field));
  appendGroup(config);
  return config;
}

bool LiveParameters::set(dynamic_reconfigure::Reconfigure::Request& request,
                         dynamic_reconfigure::Reconfigure::Response& response) {
  const bool bools = assign<bool>(live_, request.config.bools);
  const bool ints = assign<int>(live_, request.config.ints);
  const bool doubles = assign<double>(live_, request.config.doubles);
  if (bools || ints || doubles) changed_();
  response.config = inForce();
  updates_.publish(response.config);
  return true;
}

}  // namespace slam_ros
