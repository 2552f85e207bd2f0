// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <functional>
#include <map>
#include <string>

#include "slam_core/common/time.hpp"
#include "slam_ros/bag_inputs.hpp"

namespace slam_ros {

/// Publishes a product's inputs, those that a bag has, to the topics of the robot file.
class InputPublishers {
 public:
  /// Waits until a message of an input ("motion", "observations", "scans" or the name of one of a
  /// further kind, as they are acknowledged) may be sent. @return false: it is not to be sent
  using Gate = std::function<bool(const std::string& input, slam::Stamp stamp)>;

  InputPublishers(ros::NodeHandle handle, const TopicsConfig& topics, const BagInputs& inputs,
                  Gate gate);

  /// Publish what they take, when the gate lets it through. They refer to this object.
  InputSinks sinks() const;

  /// "a subscriber of /odom" while one is missing, else empty.
  std::string missingSubscriber() const;

 private:
  /// The publishers of a camera that the bag has.
  struct Camera {
    Camera() = default;
    Camera(ros::NodeHandle handle, const std::string& topic, const BagCamera& in_bag);
    ros::Publisher images, info;
  };

  template <class Message>
  void send(const ros::Publisher& publisher, const std::string& input, const ros::Time& stamp,
            const Message& message) const;

  Gate gate_;
  ros::Publisher motion_, odom_, observations_, scan_;
  std::map<std::string, ros::Publisher> others_;  ///< of further kinds, by input
  Camera camera_;                                 ///< that observations are made of
  Camera ceiling_;                                ///< that motion is made of
};

}  // namespace slam_ros
