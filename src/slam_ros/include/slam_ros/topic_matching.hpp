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

struct TopicMatch {
  std::string topic;  ///< of the bag
  std::string note;   ///< a sentence where the topic has another name than the input
};

/// Two topics fit, or the one that was named does not. The message is a sentence.
class TopicError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a topic of the bag may be called to be an input.
enum class Names {
  kOwn,  ///< as the robot's topic of the input
  kAny   ///< also by another name, where it is the only topic of the input's type
};

/// Finds an input's topic: by name, else by type where only one fits. Topics without messages, of
/// the truth, or that are the namesakes of other inputs do not count.
/// @return nothing when the bag has none @throw TopicError naming the candidates
std::optional<TopicMatch> matchTopic(const Input& input, const std::vector<Input>& all_inputs,
                                     const std::vector<BagTopic>& topics, Names names);

/// @throw TopicError where the topic cannot be the input: it has messages of another type, of
/// another version of it, or none
void requireFit(const BagTopic& topic, const Input& input);

/// Null where there is none of this name.
const BagTopic* findTopic(const std::vector<BagTopic>& topics, const std::string& name);

/// "'scan' (sensor_msgs/LaserScan)"
std::string needOf(const Input& input);

/// "/odom (nav_msgs/Odometry, 61785 messages), ..."
std::string listTopics(const std::vector<BagTopic>& topics);

/// Whether two topic names differ by the leading slash at most.
bool sameTopic(const std::string& a, const std::string& b);

}  // namespace slam_ros
