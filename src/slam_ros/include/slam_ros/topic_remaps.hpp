// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_ros/topic_matching.hpp"

namespace slam_ros {

/// A remapping of the command line: the product's input `from` is the bag's topic `to`. As `rosbag
/// play` writes it the other way round, that is understood too where it can be meant.
struct Remap {
  std::string from, to;
};

/// The topic of the bag that a remapping has chosen for an input.
struct ChosenTopic {
  Input input;
  std::string topic;  ///< as the bag writes it
  Remap remap;        ///< that says so
};

/// "from:=to" or "from=to". @throw TopicError when it is neither
Remap parseRemap(const std::string& text);
std::vector<Remap> parseRemaps(const std::vector<std::string>& texts);

/// "odom:=/wheels", as sentences call it.
std::string textOf(const Remap& remap);

/// What the remappings choose.
/// @throw TopicError for a remapping that joins no input with a topic of the bag, for one whose
/// topic cannot be that input, and for a second one of the same input
std::vector<ChosenTopic> chooseTopics(const std::vector<Remap>& remaps,
                                      const std::vector<Input>& inputs,
                                      const std::vector<BagTopic>& topics);

}  // namespace slam_ros
