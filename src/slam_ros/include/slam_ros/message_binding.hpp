// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_ros/after_load.hpp"
#include "slam_ros/input_bindings.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {

/// The binding for a kind whose values come as messages of one topic.
/// @tparam convert from message to data
template <class Message, class Data, Data (*convert)(const Message&)>
class MessageBinding final : public InputBinding {
 public:
  MessageBinding(const InputContext& context, const slam::InputPort& port)
      : name_(port.name), topic_(context.topics.of(port.name)) {
    context.handle.resolveName(topic_);  // throws now what subscribing would throw later
    const auto take = [this, put = context.put](const Message& message) {
      noteArrival();
      has_come_ = true;
      const Data data = convert(message);
      put(name_, slam::kindOf<Data>(), &data, topic_);
    };
    start_.emplace([this, take, handle = context.handle, pass = context.pass] {
      subscriber_ = subscribeThrough<Message>(pass, handle, topic_, kQueue, take);
    });
  }
  const std::string& topic() const override { return topic_; }
  std::string waiting() const override {
    return has_come_ ? "" : "waiting for " + name_ + " on " + topic_;
  }
  bool isConnected() const override { return subscriber_.getNumPublishers() > 0; }

 private:
  std::string name_, topic_;
  bool has_come_ = false;
  ros::Subscriber subscriber_;
  std::optional<AfterLoad> start_;
};

/// The binding for the same data in a bag.
template <class Message, class Data, Data (*convert)(const Message&)>
class MessageInBag : public TopicInBag {
 public:
  MessageInBag(const BagContext& context, const std::string& port)
      : TopicInBag(inputOf<Message>(port, context.topics.of(port))) {}

  BagHandlers readers(const BagSinks& sinks) override {
    const auto take = [sinks](const Message& message) { sinks.give(convert(message)); };
    return {{topic_, onMessage<Message>(take)}};
  }
  BagHandlers senders(ros::NodeHandle handle, const Gate& gate) override {
    const auto publisher = advertise<Message>(handle, input_.topic, kInFlight);
    const auto stamp = [](const Message& message) { return stampOf(convert(message)); };
    return {{topic_, sender<Message>(publisher, gate, stamp)}};
  }
};

/// A static object of this type registers a message type as the source of a kind of data, live and
/// from a bag.
/// @tparam InBag what says more of the data in a bag
template <class Message, class Data, Data (*convert)(const Message&),
          class InBag = MessageInBag<Message, Data, convert>>
struct MessageBindingRegistrar
    : InputBindingRegistrar<Data, MessageBinding<Message, Data, convert>, InBag> {};

}  // namespace slam_ros
