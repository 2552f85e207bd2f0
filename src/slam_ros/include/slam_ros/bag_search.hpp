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

/// A bag as a BagInput sees it when it looks for its topics. The class does not depend on the bag
/// library.
class BagSearch {
 public:
  /// Calls the handlers message by message, until `progress` returns false.
  using Read = std::function<void(const BagHandlers& handlers,
                                  const std::function<bool(std::size_t done)>& progress)>;

  /// @param topics of the bag @param inputs all inputs for which a topic of the bag may be used
  /// @throw TopicError for a remapping that chooses nothing, as chooseTopics() does
  BagSearch(std::vector<BagTopic> topics, Read read, std::vector<Input> inputs,
            const std::vector<Remap>& remaps);

  /// The bag's topic for an input, or an empty name. @throw TopicError naming the candidates
  std::string topic(const Input& input);
  bool isRemapped(const Input& input) const;
  /// Whether the bag has the input under its own name or a remapped one, so that it is not found by
  /// type alone.
  bool isNamed(const Input& input) const;

  /// The topics that remappings have chosen.
  const std::vector<ChosenTopic>& chosen() const { return chosen_; }

  const std::vector<BagTopic>& topics() const { return topics_; }
  /// Null if the bag has no such topic.
  const BagTopic* find(const std::string& topic) const { return findTopic(topics_, topic); }
  Read read;
  Names names = Names::kAny;  ///< that a topic of an input may have; a remapped one may have any

  std::vector<std::string> notes;     ///< a sentence each: other names, components left out
  std::vector<std::string> warnings;  ///< a sentence each: what will impair the run

 private:
  const ChosenTopic* chosenFor(const Input& input) const;
  std::vector<BagTopic> notChosen() const;

  std::vector<BagTopic> topics_;
  std::vector<Input> inputs_;
  std::vector<ChosenTopic> chosen_;
};

}  // namespace slam_ros
