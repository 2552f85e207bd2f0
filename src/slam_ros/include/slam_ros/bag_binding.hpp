// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <map>
#include <string>

#include "slam_core/contract/data.hpp"
#include "slam_ros/bag_message.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_ros {

/// How a kind of data stands in a bag: as messages of one topic. It needs no library of bags, so
/// that a package can bring one for a kind of its own.
struct BagBinding {
  using Take = std::function<void(const void* value)>;
  /// Whether data of this stamp may be sent now; it may wait.
  using Gate = std::function<bool(slam::Stamp stamp)>;

  std::string type, md5sum;
  /// A handler that gives `take` the data of each message.
  std::function<BagHandler(Take take)> reader;
  std::function<ros::Publisher(ros::NodeHandle handle, const std::string& topic,
                               std::uint32_t queue)>
      advertise;
  /// A handler that publishes each message that the gate lets through.
  std::function<BagHandler(const ros::Publisher& publisher, Gate gate)> sender;
};

/// The bag bindings there are, by the kind of their data.
class BagBindings {
 public:
  static BagBindings& instance();

  template <class Message, class Data, Data (*convert)(const Message&)>
  void add();
  /// Null where there is none.
  const BagBinding* find(slam::Kind kind) const;

 private:
  std::map<slam::Kind, BagBinding> bindings_;
};

template <class Message, class Data, Data (*convert)(const Message&)>
void BagBindings::add() {
  BagBinding binding;
  binding.type = ros::message_traits::DataType<Message>::value();
  binding.md5sum = ros::message_traits::MD5Sum<Message>::value();
  binding.reader = [](BagBinding::Take take) {
    return onMessage<Message>([take = std::move(take)](const Message& message) {
      const Data data = convert(message);
      take(&data);
    });
  };
  binding.advertise = [](ros::NodeHandle handle, const std::string& topic, std::uint32_t queue) {
    return handle.advertise<Message>(topic, queue);
  };
  binding.sender = [](const ros::Publisher& publisher, BagBinding::Gate gate) {
    return onMessage<Message>([publisher, gate = std::move(gate)](const Message& message) {
      slam::Stamp stamp;
      if constexpr (slam::detail::HasStamp<Data>::value) stamp = convert(message).stamp;
      if (gate(stamp)) publisher.publish(boost::make_shared<const Message>(message));
    });
  };
  bindings_.emplace(slam::kindOf<Data>(), std::move(binding));
}

}  // namespace slam_ros
