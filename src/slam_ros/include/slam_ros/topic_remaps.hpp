// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_ros/topic_matching.hpp"

namespace slam_ros {

/// A remapping of the command line: the product's input `from` is the bag's topic `to`. Since
/// `rosbag play` writes it the other way round, that order is also understood if it makes sense.
struct Remap {
  std::string from, to;
};

/// The topic of the bag that a remapping chooses for an input.
struct ChosenTopic {
  Input input;
  std::string topic;  ///< as it is named in the bag
  Remap remap;        ///< that chooses it
};

/// "from:=to" or "from=to". @throw TopicError when it is neither
Remap parseRemap(const std::string& text);
std::vector<Remap> parseRemaps(const std::vector<std::string>& texts);

/// "odom:=/wheels", for messages.
std::string textOf(const Remap& remap);

/// The topics that the remappings choose.
/// @throw TopicError for a remapping without an input of the product or a topic of the bag, for one
/// whose topic cannot be that input, and for a second one of the same input
std::vector<ChosenTopic> chooseTopics(const std::vector<Remap>& remaps,
                                      const std::vector<Input>& inputs,
                                      const std::vector<BagTopic>& topics);

}  // namespace slam_ros
