// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_ros/topic_matching.hpp"

namespace slam_ros {

/// Takes the messages of one topic.
using BagHandler = std::function<void(const rosbag::MessageInstance&)>;
using BagHandlers = std::map<std::string, BagHandler>;

/// Where a message's bytes are copied to; grows with the largest one.
struct MessageBytes {
  std::vector<std::uint8_t> bytes;
  std::uint8_t* advance(std::uint32_t size) { return bytes.resize(size), bytes.data(); }
};

/// Deserialises into one message that is used again and again; the callback copies what it keeps.
template <class Message, class Callback>
BagHandler onMessage(Callback callback) {
  return [callback, buffer = MessageBytes(),
          message = Message()](const rosbag::MessageInstance& instance) mutable {
    buffer.bytes.clear();
    instance.write(buffer);
    ros::serialization::IStream stream(buffer.bytes.data(),
                                       static_cast<std::uint32_t>(buffer.bytes.size()));
    ros::serialization::deserialize(stream, message);
    callback(message);
  };
}

/// A bag that is read, in the order of its receive times; only the topics asked for are touched.
/// Everything throws std::runtime_error, one sentence that names the bag and what is wrong with it.
class BagReader {
 public:
  /// @throw when it is missing, a folder, no bag, or was not closed properly
  explicit BagReader(const std::string& path);

  const std::string& path() const { return path_; }
  /// Sorted by name.
  const std::vector<BagTopic>& topics() const { return topics_; }
  const BagTopic* find(const std::string& topic) const;
  std::size_t messages(const BagHandlers& handlers) const;

  slam::Stamp begin() const { return begin_; }
  slam::Stamp end() const { return end_; }

  /// Calls the handlers, a topic each, message by message. `progress` is told how many messages are
  /// done; the reading ends when it returns false.
  void read(const BagHandlers& handlers,
            const std::function<bool(std::size_t done)>& progress = {}) const;

  /// The name of the robot file in the topic `robot`; empty where the bag does not tell.
  std::string robot() const;

 private:
  void open();
  void listTopics();

  std::string path_;
  rosbag::Bag bag_;
  std::vector<BagTopic> topics_;
  slam::Stamp begin_, end_;
};

}  // namespace slam_ros
