// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/topic_matching.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {
namespace {

// Topics that are never matched by their type: the truth, and what a recorded run had published.
constexpr const char* kTruthPrefix = "ground_truth/";
constexpr const char* kDetectionsPrefix = "detections/";
constexpr const char* kVisualPrefix = "visual_odometry/";

std::string relative(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

/// The input itself may stand in the bag under its own name although the robot's topic is another.
bool isNameOfAnother(const std::string& name, const Input& input,
                     const std::vector<Input>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [&](const auto& other) {
    return other.name != input.name &&
           (sameTopic(name, other.name) || sameTopic(name, other.topic));
  });
}

bool isNoSensor(const std::string& name) {
  const auto begin = relative(name);
  return begin.rfind(kTruthPrefix, 0) == 0 || begin.rfind(kDetectionsPrefix, 0) == 0 ||
         begin.rfind(kVisualPrefix, 0) == 0;
}

bool fits(const BagTopic& topic, const Input& input) {
  return topic.messages > 0 && topic.type == input.type && topic.md5sum == input.md5sum;
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

void requireFit(const BagTopic& topic, const Input& input) {
  if (topic.type != input.type)
    throw TopicError(
        fmt::format("the topic {} cannot be the input {}: it has messages of type {}, "
                    "needed are {}; name another topic",
                    topic.name, input.name, topic.type, input.type));
  if (topic.md5sum != input.md5sum)
    throw TopicError(
        fmt::format("the topic {} was recorded with another version of {}; import or "
                    "record the bag anew",
                    topic.name, input.type));
  if (topic.messages == 0)
    throw TopicError(
        fmt::format("the topic {} cannot be the input {}: it has no messages; name "
                    "another topic",
                    topic.name, input.name));
}

std::optional<TopicMatch> matchTopic(const Input& input, const std::vector<Input>& all_inputs,
                                     const std::vector<BagTopic>& topics, Names names) {
  std::vector<BagTopic> candidates;
  const BagTopic* of_other_version = nullptr;
  for (const auto& topic : topics) {
    const bool is_own = sameTopic(topic.name, input.topic);
    if (is_own && fits(topic, input)) return TopicMatch{topic.name, ""};
    if (is_own && topic.type == input.type && topic.messages > 0) of_other_version = &topic;
    if (names == Names::kAny && fits(topic, input) && !isNoSensor(topic.name) &&
        !isNameOfAnother(topic.name, input, all_inputs))
      candidates.push_back(topic);
  }
  if (!candidates.empty()) return onlyOne(input, candidates);
  if (of_other_version != nullptr) requireFit(*of_other_version, input);
  return std::nullopt;
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
