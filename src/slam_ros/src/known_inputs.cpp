// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/known_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/input_bindings.hpp"

namespace slam_ros {
namespace {

bool isBrought(const slam::InputPort& input, const std::vector<slam::InputPort>& open) {
  const auto& bindings = InputBindings::instance();
  return std::any_of(open.begin(), open.end(), [&](const slam::InputPort& other) {
    const bool is_same = other.name == input.name && other.kind == input.kind;
    const bool comes_along = input.time == slam::TimeRole::kLatched && other.name == input.name;
    return (is_same || comes_along) && bindings.has(other.kind);
  });
}

/// The output that may have been meant: of the same kind or name, or of a name that is near.
std::string nearTo(const slam::InputPort& input, const std::vector<slam::OutputPort>& outputs) {
  std::vector<std::string> names;
  for (const auto& output : outputs) {
    names.push_back(output.name);
    if (output.kind == input.kind || output.name == input.name)
      return fmt::format("; a component makes '{}' ({})", output.name, slam::nameOf(output.kind));
  }
  const auto bindings = InputBindings::instance().kinds();
  const auto near = slam::didYouMean(input.name, names);
  return near.empty() ? slam::didYouMean(slam::nameOf(input.kind), bindings) : near;
}

}  // namespace

void requireKnownInputs(const slam::Wiring& wiring) {
  const auto open = wiring.ports().open();
  slam::FaultCollector faults;
  for (const auto& input : open)
    if (input.is_mandatory && !isBrought(input, open))
      faults.add(fmt::format(
          "{} needs '{}' ({}), which no component of the product makes and no topic brings{}; "
          "topics bring {}: choose a component that makes it, or name the library that has a "
          "binding for it in the product's `libraries`",
          wiring.ports().takersOf(input.name, input.kind), input.name, slam::nameOf(input.kind),
          nearTo(input, wiring.ports().outputs()), slam::join(InputBindings::instance().kinds())));
  faults.raise();
}

void requireDistinctTopics(const slam::Wiring& wiring, const TopicsConfig& topics) {
  const std::string rear = "rear_";
  slam::FaultCollector faults;
  for (const auto& input : wiring.ports().open()) {
    if (input.time == slam::TimeRole::kLatched || input.name.rfind(rear, 0) != 0) continue;
    const auto other = input.name.substr(rear.size());
    if (topics.of(input.name) == topics.of(other))
      faults.add(fmt::format(
          "topics.{}: '{}' is the topic of {} already; name that of the second sensor in the robot "
          "file, or leave the second one out of the product",
          input.name, topics.of(input.name), other));
  }
  faults.raise();
}

}  // namespace slam_ros
