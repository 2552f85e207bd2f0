// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/topic_remaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {
namespace {

/// The inputs of the product's own name for them, else those on the robot's topic of this name.
std::vector<Input> inputsNamed(const std::string& name, const std::vector<Input>& inputs) {
  std::vector<Input> by_name, by_topic;
  for (const auto& input : inputs) {
    if (sameTopic(name, input.name)) by_name.push_back(input);
    if (sameTopic(name, input.topic)) by_topic.push_back(input);
  }
  return by_name.empty() ? by_topic : by_name;
}

/// Of inputs of one name and several kinds, the one that the topic's messages fit.
std::optional<ChosenTopic> joinedAs(const std::string& name, const std::string& topic_name,
                                    const std::vector<Input>& inputs,
                                    const std::vector<BagTopic>& topics) {
  const auto named = inputsNamed(name, inputs);
  const auto* topic = findTopic(topics, topic_name);
  if (named.empty() || topic == nullptr) return std::nullopt;
  const auto of_type = std::find_if(named.begin(), named.end(),
                                    [&](const auto& input) { return input.type == topic->type; });
  return ChosenTopic{of_type == named.end() ? named.front() : *of_type, topic->name, {}};
}

ChosenTopic chosenBy(const Remap& remap, const std::vector<Input>& inputs,
                     const std::vector<BagTopic>& topics) {
  auto chosen = joinedAs(remap.from, remap.to, inputs, topics);
  if (!chosen) chosen = joinedAs(remap.to, remap.from, inputs, topics);
  if (chosen) return {chosen->input, chosen->topic, remap};
  std::vector<std::string> names;
  for (const auto& input : inputs) names.push_back(input.name);
  throw TopicError(fmt::format(
      "the remapping {} joins no input with a topic of the bag{}; the inputs are {}, "
      "the bag has {}",
      textOf(remap), slam::didYouMean(remap.from, names), slam::join(names), listTopics(topics)));
}

void requireOtherInput(const ChosenTopic& chosen, const std::vector<ChosenTopic>& before) {
  for (const auto& other : before)
    if (other.input.name == chosen.input.name)
      throw TopicError(
          fmt::format("the remappings {} and {} are of the same input '{}'; leave one "
                      "of them out",
                      textOf(other.remap), textOf(chosen.remap), chosen.input.name));
}

}  // namespace

Remap parseRemap(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size())
    throw TopicError("the remapping '" + text + "' is not of the form from:=to");
  const bool has_colon = equals > 0 && text[equals - 1] == ':';
  const auto from = text.substr(0, equals - (has_colon ? 1 : 0));
  if (from.empty()) throw TopicError("the remapping '" + text + "' is not of the form from:=to");
  return {from, text.substr(equals + 1)};
}

std::vector<Remap> parseRemaps(const std::vector<std::string>& texts) {
  std::vector<Remap> remaps;
  for (const auto& text : texts) remaps.push_back(parseRemap(text));
  return remaps;
}

std::string textOf(const Remap& remap) { return remap.from + ":=" + remap.to; }

std::vector<ChosenTopic> chooseTopics(const std::vector<Remap>& remaps,
                                      const std::vector<Input>& inputs,
                                      const std::vector<BagTopic>& topics) {
  std::vector<ChosenTopic> all;
  for (const auto& remap : remaps) {
    const auto chosen = chosenBy(remap, inputs, topics);
    requireOtherInput(chosen, all);
    requireFit(*findTopic(topics, chosen.topic), chosen.input);
    all.push_back(chosen);
  }
  return all;
}

}  // namespace slam_ros
