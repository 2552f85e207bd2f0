// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/contract/data.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/bag_search.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/given_mounts.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// What a robot calls its topics and frames, and which mounts its file gives.
struct BagContext {
  TopicsConfig topics;
  slam::FramesConfig frames;
  GivenMounts mounts;
};

/// The stamp for which data hold; latched data have none.
template <class Data>
slam::Stamp stampOf([[maybe_unused]] const Data& data) {
  if constexpr (slam::detail::HasStamp<Data>::value) return data.stamp;
  return {};
}
inline slam::Stamp stampOf(const slam::Motion& motion) { return motion.end; }

/// The functions that take the data of an input's messages.
struct BagSinks {
  template <class Data>
  void give(const Data& data) const {
    put(slam::Datum::of(data), stampOf(data));
  }

  /// A value, with its stamp if its kind has one.
  std::function<void(const slam::Datum& value, slam::Stamp stamp)> put;
  std::function<void(const std::string& sentence)> warn = [](const auto&) {};
  std::function<void(const std::string& reason)> count = [](const auto&) {};
  tf2_msgs::TFMessage static_transforms;  ///< of the bag
};

/// How an input is replayed to other nodes.
struct BagPlay {
  std::size_t in_flight = kInFlight;  ///< messages sent before one is acknowledged
  /// The number of messages that a component may hold until it knows its sensor; 0: it does not
  /// wait.
  std::size_t held = 0;
  bool needs_transforms = false;  ///< the sensor's mount comes as a transform
};

/// One input of a product in a bag; there is one object for each port. BagInputs finds it; then its
/// owner asks once for readers() or for senders(). The class does not depend on the bag library, so
/// that a package can bring one for its own kind of data.
class BagInput {
 public:
  /// Whether data of this stamp may be sent now; it may wait.
  using Gate = std::function<bool(slam::Stamp stamp)>;

  virtual ~BagInput() = default;

  /// The names that remappings and messages use for it, with the robot's topics and their types.
  virtual std::vector<Input> names() const = 0;
  /// The remapping for this input, if it names one of several topics of the input.
  virtual Remap meaningOf(Remap remap, const std::vector<BagTopic>& /*topics*/) const {
    return remap;
  }
  /// Whether a remapping asks for it although the bag holds the data that are made of it.
  virtual bool isAskedFor(const BagSearch& bag) const {
    const auto inputs = names();
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const Input& input) { return bag.isRemapped(input); });
  }
  /// One clause that says how to ask for it in that way; empty if that is impossible.
  virtual std::string howToAsk() const { return ""; }

  /// @return whether the bag has it @throw TopicError if that cannot be decided
  virtual bool find(BagSearch& bag) = 0;
  /// This names what a bag must have for the input, such as "'scan' (sensor_msgs/LaserScan)".
  virtual std::string need() const = 0;
  /// The topics of the bag on which it was found, that of its data first.
  virtual std::vector<std::string> topics() const = 0;

  /// Handlers that give the data of the messages to the sinks. They refer to this object.
  virtual BagHandlers readers(const BagSinks& sinks) = 0;
  /// Why none of the messages that were read could be used, as a clause; empty if some could.
  virtual std::string lacking() const { return ""; }

  virtual BagPlay play() const { return {}; }
  /// Handlers that publish on the robot's topics what the gate lets through. They refer to this
  /// object.
  virtual BagHandlers senders(ros::NodeHandle handle, const Gate& gate) = 0;
  /// The topics on which senders() publishes.
  const std::vector<ros::Publisher>& publishers() const { return publishers_; }

 protected:
  template <class Message>
  ros::Publisher advertise(ros::NodeHandle& handle, const std::string& topic, std::size_t queue) {
    publishers_.push_back(handle.advertise<Message>(topic, static_cast<std::uint32_t>(queue)));
    return publishers_.back();
  }

 private:
  std::vector<ros::Publisher> publishers_;
};

/// An input whose topics have messages of one type.
template <class Message>
Input inputOf(const std::string& name, const std::string& topic) {
  return {name, topic, ros::message_traits::DataType<Message>::value(),
          ros::message_traits::MD5Sum<Message>::value()};
}

/// A handler that publishes each message that the gate lets through.
/// @param stampOf of a message
template <class Message, class StampOf>
BagHandler sender(const ros::Publisher& publisher, BagInput::Gate gate, StampOf stampOf) {
  return onMessage<Message>([publisher, gate = std::move(gate), stampOf](const Message& message) {
    // A pointer reaches subscribers in the same manager at once. A reference would be serialised
    // into a queue of its own, and images could overtake their calibration.
    if (gate(stampOf(message))) publisher.publish(boost::make_shared<const Message>(message));
  });
}

struct HeaderStamp {
  template <class Message>
  slam::Stamp operator()(const Message& message) const {
    return fromRos(message.header.stamp);
  }
};

/// An input on one topic.
class TopicInBag : public BagInput {
 public:
  explicit TopicInBag(Input input) : input_(std::move(input)) {}

  std::vector<Input> names() const override { return {input_}; }
  std::string howToAsk() const override {
    return "--remap " + input_.name + ":=TOPIC has it take that topic's messages instead";
  }
  bool find(BagSearch& bag) override { return !(topic_ = bag.topic(input_)).empty(); }
  std::string need() const override { return needOf(input_); }
  std::vector<std::string> topics() const override { return {topic_}; }

 protected:
  Input input_;
  std::string topic_;  ///< of the bag
};

}  // namespace slam_ros
