// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "slam_ros/bag_message.hpp"
#include "slam_ros/topic_remaps.hpp"

namespace slam_ros {

/// A bag as those see it who look for an input in it. It needs no library of bags.
class BagSearch {
 public:
  /// Calls the handlers message by message, until `progress` returns false.
  using Read = std::function<void(const BagHandlers& handlers,
                                  const std::function<bool(std::size_t done)>& progress)>;

  /// @param topics of the bag @param inputs all that a topic of the bag may be
  /// @throw TopicError for a remapping that chooses nothing, as of chooseTopics()
  BagSearch(std::vector<BagTopic> topics, Read read, std::vector<Input> inputs,
            const std::vector<Remap>& remaps);

  /// The bag's topic for an input, or an empty name. @throw TopicError naming the candidates
  std::string topic(const Input& input);
  bool isRemapped(const Input& input) const;
  /// Whether the bag has the input under its own name or a remapped one: its type need not tell.
  bool isNamed(const Input& input) const;

  /// What remappings have chosen.
  const std::vector<ChosenTopic>& chosen() const { return chosen_; }

  const std::vector<BagTopic>& topics() const { return topics_; }
  /// Null where the bag has no such topic.
  const BagTopic* find(const std::string& topic) const { return findTopic(topics_, topic); }
  Read read;
  Names names = Names::kAny;  ///< that a topic may have to be an input; a chosen one has any

  std::vector<std::string> notes;     ///< a sentence each: other names, components left out
  std::vector<std::string> warnings;  ///< a sentence each: what the run will suffer from

 private:
  const ChosenTopic* chosenFor(const Input& input) const;
  std::vector<BagTopic> notChosen() const;

  std::vector<BagTopic> topics_;
  std::vector<Input> inputs_;
  std::vector<ChosenTopic> chosen_;
};

}  // namespace slam_ros
