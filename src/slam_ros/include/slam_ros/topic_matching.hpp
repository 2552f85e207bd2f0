// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slam_ros {

/// A topic as a bag has it.
struct BagTopic {
  std::string name, type, md5sum;
  std::size_t messages = 0;
};

/// What a product can take in: its own name for it, the robot's topic, the type of its messages.
struct Input {
  std::string name;   ///< "odom", as remappings and error messages call it
  std::string topic;  ///< relative, from the robot file
  std::string type, md5sum;
};

/// A remapping of the command line: the product's input `from` is the bag's topic `to`. As `rosbag
/// play` writes it the other way round, that is understood too where it can be meant.
struct Remap {
  std::string from, to;
};

struct TopicMatch {
  std::string topic;  ///< of the bag
  std::string note;   ///< a sentence where the topic has another name than the input
};

/// Two topics fit, or the one that was named does not. The message is a sentence.
class TopicError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "from:=to" or "from=to". @throw TopicError when it is neither
Remap parseRemap(const std::string& text);
std::vector<Remap> parseRemaps(const std::vector<std::string>& texts);

/// @throw TopicError for a remapping that joins no input with a topic of the bag
void checkRemaps(const std::vector<Remap>& remaps, const std::vector<Input>& inputs,
                 const std::vector<BagTopic>& topics);

/// Finds an input's topic: by remapping, else by name, else by type where only one fits. Topics
/// without messages, of the truth, or that are the namesakes of other inputs do not count.
/// @return nothing when the bag has none @throw TopicError naming the candidates
std::optional<TopicMatch> matchTopic(const Input& input, const std::vector<Input>& all_inputs,
                                     const std::vector<BagTopic>& topics,
                                     const std::vector<Remap>& remaps);

/// Null where there is none of this name.
const BagTopic* findTopic(const std::vector<BagTopic>& topics, const std::string& name);

/// "'scan' (sensor_msgs/LaserScan)"
std::string needOf(const Input& input);

/// "/odom (nav_msgs/Odometry, 61785 messages), ..."
std::string listTopics(const std::vector<BagTopic>& topics);

/// Whether two topic names differ by the leading slash at most.
bool sameTopic(const std::string& a, const std::string& b);

}  // namespace slam_ros
