// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_search.hpp"

#include <algorithm>
#include <utility>

namespace slam_ros {

BagSearch::BagSearch(std::vector<BagTopic> topics, Read read_bag, std::vector<Input> inputs,
                     std::vector<Remap> remaps)
    : read(std::move(read_bag)),
      topics_(std::move(topics)),
      inputs_(std::move(inputs)),
      remaps_(std::move(remaps)) {
  checkRemaps(remaps_, inputs_, topics_);
}

std::string BagSearch::topic(const Input& input) {
  const auto match = matchTopic(input, inputs_, topics_, remaps_);
  if (match && !match->note.empty()) notes.push_back(match->note);
  return match ? match->topic : "";
}

bool BagSearch::isRemapped(const Input& input) const {
  return std::any_of(remaps_.begin(), remaps_.end(), [&](const auto& remap) {
    return sameTopic(remap.from, input.name) || sameTopic(remap.to, input.name);
  });
}

bool BagSearch::isNamed(const Input& input) const {
  const auto* topic = find(input.topic);
  return isRemapped(input) ||
         (topic != nullptr && topic->messages > 0 && topic->type == input.type);
}

}  // namespace slam_ros
