// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slam_ros {

/// One message of a bag, serialised.
struct BagMessage {
  const std::string& topic;
  ros::Time time;  ///< of receipt
  std::vector<std::uint8_t>& bytes;
};

/// Takes the messages of one topic.
using BagHandler = std::function<void(const BagMessage&)>;
using BagHandlers = std::map<std::string, BagHandler>;

/// Refuses a list that is longer than the remaining bytes, before memory is allocated for it: ROS's
/// own stream would allocate whatever a damaged length says.
class CheckedStream : public ros::serialization::Stream {
 public:
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Input;

  explicit CheckedStream(std::vector<std::uint8_t>& bytes)
      : Stream(bytes.data(), static_cast<std::uint32_t>(bytes.size())) {}

  template <class Value>
  void next(Value& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <class Value, class Allocator>
  void next(std::vector<Value, Allocator>& list) {
    requireRoom<Value>();
    ros::serialization::deserialize(*this, list);
  }

 private:
  template <class Value>
  void requireRoom() {
    auto ahead = *this;
    std::uint32_t length = 0;
    ros::serialization::deserialize(ahead, length);
    const std::uint64_t each = ros::message_traits::isFixedSize<Value>()
                                   ? ros::serialization::serializationLength(Value())
                                   : 1;
    if (length * each > ahead.getLength()) ros::serialization::throwStreamOverrun();
  }
};

/// Deserialises into one message that is reused; the callback copies what it keeps. The handler
/// throws ros::serialization::StreamOverrunException.
template <class Message, class Callback>
BagHandler onMessage(Callback callback) {
  return [callback, message = Message()](const BagMessage& given) mutable {
    CheckedStream stream(given.bytes);
    ros::serialization::deserialize(stream, message);
    callback(message);
  };
}

}  // namespace slam_ros
