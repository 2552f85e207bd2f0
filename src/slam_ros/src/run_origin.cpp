// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/run_origin.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"

namespace slam_ros {
namespace {

using Json = nlohmann::ordered_json;

/// A line for each member; JSON is YAML as well.
void appendMembers(std::string& yaml, const Json& members, const std::string& indent) {
  for (const auto& [name, value] : members.items()) {
    yaml += indent + name + ":";
    if (value.is_object()) {
      yaml += "\n";
      appendMembers(yaml, value, indent + "  ");
    } else {
      yaml += " " + value.dump() + "\n";
    }
  }
}

}  // namespace

RunOrigin::RunOrigin(const std::string& text) : text_(text) {
  if (text_.empty()) return;
  const auto origin = Json::parse(text_, nullptr, false);
  if (!origin.is_object())
    throw std::invalid_argument("the origin of the run is no object of JSON: " + text_);
}

std::string RunOrigin::addedToMetrics(const std::string& metrics) const {
  if (text_.empty()) return metrics;
  auto values = Json::parse(metrics);
  values["run"] = Json::parse(text_);
  return values.dump(2) + "\n";
}

std::string RunOrigin::addedToConfig(const std::string& config) const {
  if (text_.empty()) return config;
  auto origin = Json::parse(text_);
  for (const auto* name : {"date", "command"}) origin.erase(name);
  auto added = config + "run:\n";
  appendMembers(added, origin, "  ");
  return added;
}

void RunOrigin::addToFolder(const std::string& folder) const {
  const auto metrics = folder + "/metrics.json", config = folder + "/config.yaml";
  if (std::filesystem::exists(metrics))
    slam::writeFileAtomically(metrics, addedToMetrics(slam::readInputFile(metrics, "the metrics")));
  slam::writeFileAtomically(config, addedToConfig(slam::readInputFile(config, "the settings")));
}

}  // namespace slam_ros
