// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slam_ros {

/// A topic of a bag.
struct BagTopic {
  std::string name, type, md5sum;
  std::size_t messages = 0;
};

/// An input of a product: its name, the robot's topic, the type of its messages.
struct Input {
  std::string name;   ///< "odom", as remappings and error messages call it
  std::string topic;  ///< relative, from the robot file
  std::string type, md5sum;
};

struct TopicMatch {
  std::string topic;  ///< of the bag
  std::string note;   ///< a sentence if the topic has another name than the input
};

/// Two topics match, or the named topic does not. The message is a sentence.
class TopicError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The names that a topic of the bag may have to be used as an input.
enum class Names {
  kOwn,  ///< only the robot's topic of the input
  kAny   ///< also another name, if it is the only topic of the input's type
};

/// Finds the topic of an input: by name, or by type if only one topic has it. Topics without
/// messages, topics of the truth, and topics with the name of another input are ignored.
/// @return nothing if the bag has none @throw TopicError naming the candidates
std::optional<TopicMatch> matchTopic(const Input& input, const std::vector<Input>& all_inputs,
                                     const std::vector<BagTopic>& topics, Names names);

/// @throw TopicError if the topic cannot be the input, since it has messages of another type or of
/// another version of it, or no messages
void requireFit(const BagTopic& topic, const Input& input);

/// Null if there is none of this name.
const BagTopic* findTopic(const std::vector<BagTopic>& topics, const std::string& name);

/// "'scan' (sensor_msgs/LaserScan)"
std::string needOf(const Input& input);

/// "/odom (nav_msgs/Odometry, 61785 messages), ..."
std::string listTopics(const std::vector<BagTopic>& topics);

/// Whether two topic names are the same except for a leading slash.
bool sameTopic(const std::string& a, const std::string& b);

}  // namespace slam_ros
