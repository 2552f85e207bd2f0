// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_search.hpp"

#include <algorithm>
#include <utility>

namespace slam_ros {

BagSearch::BagSearch(std::vector<BagTopic> topics, Read read_bag, std::vector<Input> inputs,
                     const std::vector<Remap>& remaps)
    : read(std::move(read_bag)),
      topics_(std::move(topics)),
      inputs_(std::move(inputs)),
      chosen_(chooseTopics(remaps, inputs_, topics_)) {}

std::string BagSearch::topic(const Input& input) {
  if (const auto* chosen = chosenFor(input)) {
    if (!sameTopic(chosen->topic, input.topic))
      notes.push_back(chosen->topic + " is the input " + input.name);
    return chosen->topic;
  }
  const auto match = matchTopic(input, inputs_, notChosen(), names);
  if (match && !match->note.empty()) notes.push_back(match->note);
  return match ? match->topic : "";
}

bool BagSearch::isRemapped(const Input& input) const { return chosenFor(input) != nullptr; }

bool BagSearch::isNamed(const Input& input) const {
  const auto* topic = find(input.topic);
  return isRemapped(input) ||
         (topic != nullptr && topic->messages > 0 && topic->type == input.type);
}

const ChosenTopic* BagSearch::chosenFor(const Input& input) const {
  const auto found = std::find_if(chosen_.begin(), chosen_.end(), [&](const auto& chosen) {
    return chosen.input.name == input.name && chosen.input.type == input.type;
  });
  return found == chosen_.end() ? nullptr : &*found;
}

/// The topics that may be any input: one that is chosen for an input is no candidate for another.
std::vector<BagTopic> BagSearch::notChosen() const {
  auto topics = topics_;
  const auto is_chosen = [this](const BagTopic& topic) {
    return std::any_of(chosen_.begin(), chosen_.end(),
                       [&](const auto& chosen) { return chosen.topic == topic.name; });
  };
  topics.erase(std::remove_if(topics.begin(), topics.end(), is_chosen), topics.end());
  return topics;
}

}  // namespace slam_ros
