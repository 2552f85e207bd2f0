// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/input_publishers.hpp"

#include <utility>

#include "slam_ros/camera_topics.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {
namespace {

/// By pointer, which is there at once for whoever is in the same manager; by reference it would go
/// through a queue of its own and images overtake their calibration.
template <class Message>
void publish(const ros::Publisher& publisher, const Message& message) {
  publisher.publish(boost::make_shared<const Message>(message));
}

}  // namespace

InputPublishers::Camera::Camera(ros::NodeHandle handle, const std::string& topic,
                                const BagCamera& in_bag) {
  const auto topics = cameraTopics(topic);
  if (!in_bag.image.empty())
    images = handle.advertise<sensor_msgs::Image>(topics.raw, kImageQueue);
  else if (!in_bag.compressed_image.empty())
    images = handle.advertise<sensor_msgs::CompressedImage>(topics.compressed, kImageQueue);
  if (!in_bag.camera_info.empty())
    info = handle.advertise<sensor_msgs::CameraInfo>(topics.info, kQueue);
}

InputPublishers::InputPublishers(ros::NodeHandle handle, const TopicsConfig& topics,
                                 const BagInputs& inputs, Gate gate)
    : gate_(std::move(gate)),
      camera_(handle, topics.camera, inputs),
      ceiling_(handle, topics.ceiling_camera, inputs.ceiling) {
  if (!inputs.motion.empty())
    motion_ = handle.advertise<slam_msgs::Motion>(topics.motion, kInFlight);
  if (!inputs.odom.empty() || !inputs.tf.empty())
    odom_ = handle.advertise<nav_msgs::Odometry>(topics.odom, kInFlight);
  if (!inputs.scan.empty())
    scan_ = handle.advertise<sensor_msgs::LaserScan>(topics.scan, kInFlight);
  if (!inputs.observations.empty())
    observations_ =
        handle.advertise<slam_msgs::LandmarkObservationArray>(topics.observations, kInFlight);
  for (const auto& [name, other] : inputs.others)
    others_[name] =
        BagBindings::instance().find(other.kind)->advertise(handle, topics.of(name), kInFlight);
}

InputSinks InputPublishers::sinks() const {
  InputSinks sinks;
  sinks.other = [this](const auto& input, auto, const auto& binding) {
    return binding.sender(others_.at(input),
                          [this, input](auto stamp) { return gate_(input, stamp); });
  };
  sinks.motion = [this](const auto& message) { send(motion_, "motion", message.end, message); };
  sinks.odom = [this](const auto& message) {
    // of images comes the motion that is acknowledged, where there are some
    if (ceiling_.images)
      publish(odom_, message);
    else
      send(odom_, "motion", message.header.stamp, message);
  };
  sinks.observations = [this](const auto& message) {
    send(observations_, "observations", message.header.stamp, message);
  };
  sinks.scan = [this](const auto& message) { send(scan_, "scans", message.header.stamp, message); };
  // of every image comes an array or a motion, which is what is acknowledged
  const auto observe = [this](const auto& message) {
    send(camera_.images, "observations", message.header.stamp, message);
  };
  const auto move = [this](const auto& message) {
    send(ceiling_.images, "motion", message.header.stamp, message);
  };
  const auto publisher = [](const Camera& camera) {
    return [&camera](const auto& message) { publish(camera.info, message); };
  };
  static_cast<CameraSinks&>(sinks) = {observe, observe, publisher(camera_)};
  sinks.ceiling = {move, move, publisher(ceiling_)};
  return sinks;
}

std::string InputPublishers::missingSubscriber() const {
  for (const auto* publisher : {&motion_, &odom_, &observations_, &scan_, &camera_.images,
                                &camera_.info, &ceiling_.images, &ceiling_.info})
    if (*publisher && publisher->getNumSubscribers() == 0)
      return "a subscriber of " + publisher->getTopic();
  for (const auto& [name, publisher] : others_)
    if (publisher.getNumSubscribers() == 0) return "a subscriber of " + publisher.getTopic();
  return "";
}

template <class Message>
void InputPublishers::send(const ros::Publisher& publisher, const std::string& input,
                           const ros::Time& stamp, const Message& message) const {
  if (gate_(input, fromRos(stamp))) publish(publisher, message);
}

}  // namespace slam_ros
