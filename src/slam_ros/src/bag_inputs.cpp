// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_inputs.hpp"

#include <fmt/format.h>
#include <ros/message_traits.h>

#include "slam_core/common/nearest_name.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

template <class Message>
Input input(const std::string& name, const std::string& topic) {
  return {name, topic, ros::message_traits::DataType<Message>::value(),
          ros::message_traits::MD5Sum<Message>::value()};
}

bool isOdometry(const geometry_msgs::TransformStamped& edge, const BagInputs& inputs) {
  return frameId(edge.header.frame_id) == inputs.odom_frame &&
         frameId(edge.child_frame_id) == inputs.base_frame;
}

bool hasOdometryEdge(const BagReader& bag, const std::string& topic, const BagInputs& inputs) {
  bool found = false;
  const auto look = [&](const tf2_msgs::TFMessage& message) {
    for (const auto& edge : message.transforms) found = found || isOdometry(edge, inputs);
  };
  bag.read({{topic, onMessage<tf2_msgs::TFMessage>(look)}}, [&](std::size_t) { return !found; });
  return found;
}

nav_msgs::Odometry toOdometry(const geometry_msgs::TransformStamped& edge) {
  nav_msgs::Odometry message;
  message.header = edge.header;
  message.child_frame_id = edge.child_frame_id;
  message.pose.pose.position.x = edge.transform.translation.x;
  message.pose.pose.position.y = edge.transform.translation.y;
  message.pose.pose.position.z = edge.transform.translation.z;
  message.pose.pose.orientation = edge.transform.rotation;
  return message;
}

/// An edge that is sent again with the same stamp tells nothing new.
BagHandler edgeHandler(const BagInputs& inputs,
                       const std::function<void(const nav_msgs::Odometry&)>& sink) {
  return onMessage<tf2_msgs::TFMessage>(
      [inputs, sink, last = ros::Time()](const tf2_msgs::TFMessage& message) mutable {
        for (const auto& edge : message.transforms) {
          if (!isOdometry(edge, inputs) || edge.header.stamp == last) continue;
          last = edge.header.stamp;
          sink(toOdometry(edge));
        }
      });
}

/// Searches the bag for one input after the other and notes what it finds.
class Search {
 public:
  Search(const BagReader& bag, const std::vector<Input>& inputs, const std::vector<Remap>& remaps)
      : bag_(bag), inputs_(inputs), remaps_(remaps) {
    checkRemaps(remaps, inputs, bag.topics());
  }

  /// The bag's topic for an input, or an empty name.
  std::string topic(const std::string& name, std::vector<std::string>& notes) const {
    for (const auto& entry : inputs_) {
      if (entry.name != name) continue;
      const auto match = matchTopic(entry, inputs_, bag_.topics(), remaps_);
      if (match && !match->note.empty()) notes.push_back(match->note);
      return match ? match->topic : "";
    }
    return "";
  }

  std::string need(const std::string& name) const {
    for (const auto& entry : inputs_)
      if (entry.name == name) return fmt::format("'{}' ({})", entry.topic, entry.type);
    return name;
  }

 private:
  const BagReader& bag_;
  const std::vector<Input>& inputs_;
  const std::vector<Remap>& remaps_;
};

void findEdge(const BagReader& bag, BagInputs& inputs) {
  for (const auto& topic : bag.topics()) {
    if (!sameTopic(topic.name, "tf") || !holdsTransforms(topic)) continue;
    if (!hasOdometryEdge(bag, topic.name, inputs)) continue;
    inputs.tf = topic.name;
    inputs.notes.push_back(fmt::format("odometry is taken from the transform {} -> {} of {}",
                                       inputs.odom_frame, inputs.base_frame, topic.name));
  }
}

}  // namespace

std::vector<Input> inputsOf(const TopicsConfig& topics) {
  return {input<slam_msgs::Motion>("motion", topics.motion),
          input<nav_msgs::Odometry>("odom", topics.odom),
          input<slam_msgs::LandmarkObservationArray>("observations", topics.observations)};
}

BagInputs findInputs(const BagReader& bag, const TopicsConfig& topics,
                     const slam::FramesConfig& frames, const std::vector<Remap>& remaps) {
  const auto all = inputsOf(topics);
  const Search search(bag, all, remaps);
  BagInputs inputs;
  inputs.odom_frame = frameId(frames.odom);
  inputs.base_frame = frameId(frames.base);
  inputs.motion = search.topic("motion", inputs.notes);
  if (!inputs.motion.empty())
    inputs.notes.push_back("the bag carries motion: the odometry component is left out");
  else
    inputs.odom = search.topic("odom", inputs.notes);
  if (inputs.motion.empty() && inputs.odom.empty()) findEdge(bag, inputs);
  inputs.observations = search.topic("observations", inputs.notes);

  std::vector<std::string> missing;
  if (inputs.motion.empty() && inputs.odom.empty() && inputs.tf.empty())
    missing.push_back(fmt::format("odometry: {}, or the transform {} -> {} in /tf",
                                  search.need("odom"), inputs.odom_frame, inputs.base_frame));
  if (inputs.observations.empty()) missing.push_back("landmarks: " + search.need("observations"));
  if (!missing.empty())
    throw TopicError(fmt::format("the bag {} lacks {}; it has {}", bag.path(),
                                 slam::join(missing, " and "), listTopics(bag.topics())));
  return inputs;
}

BagHandlers handlersFor(const BagInputs& inputs, const InputSinks& sinks) {
  BagHandlers handlers;
  if (!inputs.motion.empty()) handlers[inputs.motion] = onMessage<slam_msgs::Motion>(sinks.motion);
  if (!inputs.odom.empty()) handlers[inputs.odom] = onMessage<nav_msgs::Odometry>(sinks.odom);
  if (!inputs.tf.empty()) handlers[inputs.tf] = edgeHandler(inputs, sinks.odom);
  if (!inputs.observations.empty())
    handlers[inputs.observations] =
        onMessage<slam_msgs::LandmarkObservationArray>(sinks.observations);
  return handlers;
}

/// The old tf/tfMessage has the same layout, hence the same sum.
bool holdsTransforms(const BagTopic& topic) {
  return topic.messages > 0 &&
         topic.md5sum == ros::message_traits::MD5Sum<tf2_msgs::TFMessage>::value();
}

tf2_msgs::TFMessage withoutMap(const tf2_msgs::TFMessage& message, const std::string& map_frame) {
  tf2_msgs::TFMessage kept;
  for (const auto& edge : message.transforms)
    if (frameId(edge.header.frame_id) != map_frame) kept.transforms.push_back(edge);
  return kept;
}

tf2_msgs::TFMessage staticTransforms(const BagReader& bag, const std::string& map_frame) {
  tf2_msgs::TFMessage all;
  const auto* topic = bag.find("tf_static");
  if (topic == nullptr || !holdsTransforms(*topic)) return all;
  std::map<std::string, geometry_msgs::TransformStamped> newest;
  const auto take = [&](const tf2_msgs::TFMessage& message) {
    for (const auto& edge : withoutMap(message, map_frame).transforms)
      newest[frameId(edge.child_frame_id)] = edge;
  };
  bag.read({{topic->name, onMessage<tf2_msgs::TFMessage>(take)}});
  for (const auto& entry : newest) all.transforms.push_back(entry.second);
  return all;
}

}  // namespace slam_ros
