// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/topic_matching.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {
namespace {

// never matched by their type: the truth, and what a run that was recorded had published
constexpr const char* kTruthPrefix = "ground_truth/";
constexpr const char* kDetectionsPrefix = "detections/";
constexpr const char* kVisualPrefix = "visual_odometry/";

std::string relative(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

bool isNameOf(const std::string& name, const Input& input) {
  return sameTopic(name, input.name) || sameTopic(name, input.topic);
}

bool isInput(const std::string& name, const std::vector<Input>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(),
                     [&](const auto& input) { return isNameOf(name, input); });
}

/// The remapping read as input -> topic of the bag, or nothing when it can be read neither way.
std::optional<Remap> oriented(const Remap& remap, const std::vector<Input>& inputs,
                              const std::vector<BagTopic>& topics) {
  if (isInput(remap.from, inputs) && findTopic(topics, remap.to)) return remap;
  if (isInput(remap.to, inputs) && findTopic(topics, remap.from))
    return Remap{remap.to, remap.from};
  return std::nullopt;
}

bool fits(const BagTopic& topic, const Input& input) {
  return topic.messages > 0 && topic.type == input.type && topic.md5sum == input.md5sum;
}

TopicMatch named(const Input& input, const BagTopic& topic) {
  if (topic.type != input.type)
    throw TopicError(
        fmt::format("the topic {} cannot be the input {}: it has messages of type {}, "
                    "needed are {}",
                    topic.name, input.name, topic.type, input.type));
  if (topic.md5sum != input.md5sum)
    throw TopicError(
        fmt::format("the topic {} was recorded with another version of {}; import or "
                    "record the bag anew",
                    topic.name, input.type));
  const auto note = fmt::format("{} is the input {}", topic.name, input.name);
  return {topic.name, sameTopic(topic.name, input.topic) ? "" : note};
}

TopicMatch onlyOne(const Input& input, const std::vector<BagTopic>& candidates) {
  if (candidates.size() > 1)
    throw TopicError(fmt::format("the input {} could be any of {}; choose with --remap {}:={}",
                                 input.name, listTopics(candidates), input.name,
                                 candidates.front().name));
  return {candidates.front().name, fmt::format("{} is the input {}: the only one of type {}",
                                               candidates.front().name, input.name, input.type)};
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

void checkRemaps(const std::vector<Remap>& remaps, const std::vector<Input>& inputs,
                 const std::vector<BagTopic>& topics) {
  std::vector<std::string> names;
  for (const auto& input : inputs) names.push_back(input.name);
  for (const auto& remap : remaps)
    if (!oriented(remap, inputs, topics))
      throw TopicError(fmt::format(
          "the remapping {}:={} joins no input with a topic of the bag{}; the inputs are {}, the "
          "bag has {}",
          remap.from, remap.to, slam::didYouMean(remap.from, names), slam::join(names),
          listTopics(topics)));
}

std::optional<TopicMatch> matchTopic(const Input& input, const std::vector<Input>& all_inputs,
                                     const std::vector<BagTopic>& topics,
                                     const std::vector<Remap>& remaps) {
  std::vector<std::string> taken;
  for (const auto& remap : remaps) {
    const auto joined = oriented(remap, all_inputs, topics);
    if (!joined) continue;
    if (isNameOf(joined->from, input)) return named(input, *findTopic(topics, joined->to));
    taken.push_back(joined->to);
  }
  const auto is_taken = [&](const std::string& topic) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const auto& name) { return sameTopic(name, topic); });
  };
  std::vector<BagTopic> candidates;
  for (const auto& topic : topics) {
    if (is_taken(topic.name) || !fits(topic, input)) continue;
    if (sameTopic(topic.name, input.topic)) return TopicMatch{topic.name, ""};
    const bool is_no_sensor = relative(topic.name).rfind(kTruthPrefix, 0) == 0 ||
                              relative(topic.name).rfind(kDetectionsPrefix, 0) == 0 ||
                              relative(topic.name).rfind(kVisualPrefix, 0) == 0;
    if (!is_no_sensor && !isInput(topic.name, all_inputs)) candidates.push_back(topic);
  }
  const auto* namesake = findTopic(topics, input.topic);
  if (candidates.empty() && namesake && namesake->messages > 0 && namesake->type == input.type &&
      !is_taken(namesake->name))
    return named(input, *namesake);  // which tells that the versions differ
  if (candidates.empty()) return std::nullopt;
  return onlyOne(input, candidates);
}

const BagTopic* findTopic(const std::vector<BagTopic>& topics, const std::string& name) {
  const auto found = std::find_if(topics.begin(), topics.end(),
                                  [&](const auto& topic) { return sameTopic(topic.name, name); });
  return found == topics.end() ? nullptr : &*found;
}

std::string needOf(const Input& input) { return fmt::format("'{}' ({})", input.topic, input.type); }

std::string listTopics(const std::vector<BagTopic>& topics) {
  std::vector<std::string> texts;
  for (const auto& topic : topics)
    texts.push_back(fmt::format("{} ({}, {} message{})", topic.name, topic.type, topic.messages,
                                topic.messages == 1 ? "" : "s"));
  return texts.empty() ? "no topic" : slam::join(texts);
}

bool sameTopic(const std::string& a, const std::string& b) { return relative(a) == relative(b); }

}  // namespace slam_ros
