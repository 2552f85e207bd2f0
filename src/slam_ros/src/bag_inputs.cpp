// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_inputs.hpp"

#include <fmt/format.h>
#include <ros/message_traits.h>

#include <algorithm>

#include "slam_core/common/nearest_name.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

// the inputs' names for remappings and messages
constexpr const char* kCamera = "camera";
constexpr const char* kCompressedCamera = "camera/compressed";
constexpr const char* kCameraInfo = "camera_info";

template <class Message>
Input input(const std::string& name, const std::string& topic) {
  return {name, topic, ros::message_traits::DataType<Message>::value(),
          ros::message_traits::MD5Sum<Message>::value()};
}

/// Searches the bag for one input after the other and notes what it finds.
class Search {
 public:
  Search(const BagReader& bag, const std::vector<Input>& inputs, const std::vector<Remap>& remaps)
      : bag_(bag), inputs_(inputs), remaps_(remaps) {
    checkRemaps(remaps_, inputs, bag.topics());
  }

  /// The bag's topic for an input, or an empty name.
  std::string topic(const std::string& name, std::vector<std::string>& notes) const {
    const auto match = matchTopic(entry(name), inputs_, bag_.topics(), remaps_);
    if (match && !match->note.empty()) notes.push_back(match->note);
    return match ? match->topic : "";
  }

  bool isRemapped(const std::string& name) const {
    return std::any_of(remaps_.begin(), remaps_.end(), [&](const auto& remap) {
      return sameTopic(remap.from, name) || sameTopic(remap.to, name);
    });
  }

  /// Whether the bag has the input under its own name or a remapped one: its type need not tell.
  bool isNamed(const std::string& name) const {
    const auto& wanted = entry(name);
    const auto* topic = bag_.find(wanted.topic);
    return isRemapped(name) ||
           (topic != nullptr && topic->messages > 0 && topic->type == wanted.type);
  }

  std::string need(const std::string& name) const {
    return fmt::format("'{}' ({})", entry(name).topic, entry(name).type);
  }

 private:
  const Input& entry(const std::string& name) const {
    return *std::find_if(inputs_.begin(), inputs_.end(),
                         [&](const auto& input) { return input.name == name; });
  }

  const BagReader& bag_;
  const std::vector<Input>& inputs_;
  std::vector<Remap> remaps_;
};

/// A camera that is remapped to compressed images, also where only they have the name's beginning,
/// is the input for those.
std::vector<Remap> forCompressedImages(std::vector<Remap> remaps, const BagReader& bag) {
  const auto type = ros::message_traits::DataType<sensor_msgs::CompressedImage>::value();
  for (auto& remap : remaps) {
    auto& camera = sameTopic(remap.to, kCamera) ? remap.to : remap.from;
    auto& topic = &camera == &remap.to ? remap.from : remap.to;
    if (!sameTopic(camera, kCamera)) continue;
    if (bag.find(topic) == nullptr) {
      if (const auto compressed = cameraTopics(topic).compressed; bag.find(compressed) != nullptr)
        topic = compressed;
    }
    if (const auto* found = bag.find(topic); found != nullptr && found->type == type)
      camera = kCompressedCamera;
  }
  return remaps;
}

void findCamera(const BagReader& bag, const Search& search, BagInputs& inputs) {
  const bool only_compressed = !search.isNamed(kCamera) && search.isNamed(kCompressedCamera);
  if (!only_compressed) inputs.image = search.topic(kCamera, inputs.notes);
  if (inputs.image.empty()) inputs.compressed_image = search.topic(kCompressedCamera, inputs.notes);
  if (!inputs.hasImages()) return;
  const auto& image = inputs.image.empty() ? inputs.compressed_image : inputs.image;
  const auto* sibling = bag.find(cameraTopics(image).info);
  // another camera's calibration would be worse than none: the type alone does not tell
  if (search.isRemapped(kCameraInfo))
    inputs.camera_info = search.topic(kCameraInfo, inputs.notes);
  else if (sibling != nullptr && sibling->messages > 0)
    inputs.camera_info = sibling->name;
  else
    inputs.warnings.push_back(fmt::format(
        "the bag has no {} that calibrates the camera {}: nothing can be seen in its images; name "
        "the topic with --remap camera_info:=TOPIC",
        cameraTopics(image).info, image));
}

void findOdometry(const BagReader& bag, const Search& search, BagInputs& inputs) {
  inputs.motion = search.topic("motion", inputs.notes);
  if (!inputs.motion.empty()) {
    inputs.notes.push_back("the bag carries motion: the odometry component is left out");
    return;
  }
  inputs.odom = search.topic("odom", inputs.notes);
  if (!inputs.odom.empty()) return;
  inputs.tf = findOdometryEdge(bag, inputs.odom_frame, inputs.base_frame);
  if (!inputs.tf.empty())
    inputs.notes.push_back(fmt::format("odometry is taken from the transform {} -> {} of {}",
                                       inputs.odom_frame, inputs.base_frame, inputs.tf));
}

}  // namespace

std::vector<Input> inputsOf(const TopicsConfig& topics) {
  const auto camera = cameraTopics(topics.camera);
  return {input<slam_msgs::Motion>("motion", topics.motion),
          input<nav_msgs::Odometry>("odom", topics.odom),
          input<slam_msgs::LandmarkObservationArray>("observations", topics.observations),
          input<sensor_msgs::Image>(kCamera, camera.raw),
          input<sensor_msgs::CompressedImage>(kCompressedCamera, camera.compressed),
          input<sensor_msgs::CameraInfo>(kCameraInfo, camera.info)};
}

BagInputs findInputs(const BagReader& bag, const InputNeeds& needs,
                     const std::vector<Remap>& remaps) {
  const auto all = inputsOf(needs.topics);
  const Search search(bag, all, forCompressedImages(remaps, bag));
  BagInputs inputs;
  inputs.odom_frame = frameId(needs.frames.odom);
  inputs.base_frame = frameId(needs.frames.base);
  findOdometry(bag, search, inputs);
  const bool asked_for_images =
      needs.images && (search.isRemapped(kCamera) || search.isRemapped(kCompressedCamera));
  if (!asked_for_images) inputs.observations = search.topic("observations", inputs.notes);
  if (needs.images && !inputs.observations.empty())
    inputs.notes.push_back(
        "the bag carries observations: the detector is left out; --remap camera:=TOPIC has it look "
        "at that camera's images instead");
  else if (needs.images)
    findCamera(bag, search, inputs);

  std::vector<std::string> missing;
  if (inputs.motion.empty() && inputs.odom.empty() && inputs.tf.empty())
    missing.push_back(fmt::format("odometry: {}, or the transform {} -> {} in /tf",
                                  search.need("odom"), inputs.odom_frame, inputs.base_frame));
  if (inputs.observations.empty() && !inputs.hasImages())
    missing.push_back("landmarks: " + search.need("observations") +
                      (needs.images ? ", or images: " + search.need(kCamera) + " or " +
                                          search.need(kCompressedCamera)
                                    : ""));
  if (!missing.empty())
    throw TopicError(fmt::format("the bag {} lacks {}; it has {}", bag.path(),
                                 slam::join(missing, " and "), listTopics(bag.topics())));
  return inputs;
}

BagHandlers handlersFor(const BagInputs& inputs, const InputSinks& sinks) {
  BagHandlers handlers;
  const auto add = [&](const std::string& topic, auto message, const auto& sink) {
    if (!topic.empty()) handlers[topic] = onMessage<decltype(message)>(sink);
  };
  add(inputs.motion, slam_msgs::Motion(), sinks.motion);
  add(inputs.odom, nav_msgs::Odometry(), sinks.odom);
  add(inputs.observations, slam_msgs::LandmarkObservationArray(), sinks.observations);
  add(inputs.image, sensor_msgs::Image(), sinks.image);
  add(inputs.compressed_image, sensor_msgs::CompressedImage(), sinks.compressed_image);
  add(inputs.camera_info, sensor_msgs::CameraInfo(), sinks.camera_info);
  if (!inputs.tf.empty())
    handlers[inputs.tf] = odometryOfEdge(inputs.odom_frame, inputs.base_frame, sinks.odom);
  return handlers;
}

}  // namespace slam_ros
