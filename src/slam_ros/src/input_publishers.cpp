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

InputPublishers::InputPublishers(ros::NodeHandle handle, const TopicsConfig& topics,
                                 const BagInputs& inputs, Gate gate)
    : gate_(std::move(gate)) {
  const auto camera = cameraTopics(topics.camera);
  odometry_ = inputs.motion.empty() ? handle.advertise<nav_msgs::Odometry>(topics.odom, kInFlight)
                                    : handle.advertise<slam_msgs::Motion>(topics.motion, kInFlight);
  if (!inputs.image.empty())
    observations_ = handle.advertise<sensor_msgs::Image>(camera.raw, kImageQueue);
  else if (!inputs.compressed_image.empty())
    observations_ = handle.advertise<sensor_msgs::CompressedImage>(camera.compressed, kImageQueue);
  else
    observations_ =
        handle.advertise<slam_msgs::LandmarkObservationArray>(topics.observations, kInFlight);
  if (!inputs.camera_info.empty())
    camera_info_ = handle.advertise<sensor_msgs::CameraInfo>(camera.info, kQueue);
}

InputSinks InputPublishers::sinks() const {
  InputSinks sinks;
  sinks.motion = [this](const auto& message) { send(odometry_, "motion", message.end, message); };
  sinks.odom = [this](const auto& message) {
    send(odometry_, "motion", message.header.stamp, message);
  };
  // of every image comes an array, which is what is acknowledged
  const auto observe = [this](const auto& message) {
    send(observations_, "observations", message.header.stamp, message);
  };
  sinks.observations = observe;
  sinks.image = observe;
  sinks.compressed_image = observe;
  sinks.camera_info = [this](const auto& message) { publish(camera_info_, message); };
  return sinks;
}

std::string InputPublishers::missingSubscriber() const {
  for (const auto* publisher : {&odometry_, &observations_, &camera_info_})
    if (*publisher && publisher->getNumSubscribers() == 0)
      return "a subscriber of " + publisher->getTopic();
  return "";
}

template <class Message>
void InputPublishers::send(const ros::Publisher& publisher, const std::string& input,
                           const ros::Time& stamp, const Message& message) const {
  if (gate_(input, fromRos(stamp))) publish(publisher, message);
}

}  // namespace slam_ros
