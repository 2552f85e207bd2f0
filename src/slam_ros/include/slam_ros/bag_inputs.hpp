// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Odometry.h>
#include <slam_msgs/LandmarkObservationArray.h>
#include <slam_msgs/Motion.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>
#include <vector>

#include "slam_core/product/product_config.hpp"
#include "slam_ros/bag_reader.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// Where a product's inputs stand in a bag. An empty topic: that input does not come from the bag.
struct BagInputs {
  std::string motion, odom, observations;
  std::string tf;  ///< the odometry is an edge of this topic
  std::string odom_frame, base_frame;
  std::vector<std::string> notes;  ///< a sentence each: other names, components left out
};

/// Takes what the bag's inputs hold, in bag order.
struct InputSinks {
  std::function<void(const slam_msgs::Motion&)> motion;
  std::function<void(const nav_msgs::Odometry&)> odom;
  std::function<void(const slam_msgs::LandmarkObservationArray&)> observations;
};

std::vector<Input> inputsOf(const TopicsConfig& topics);

/// Motion in the bag comes before odometry, that before the edge odom -> base of /tf.
/// @throw TopicError when an input the product needs is missing (with what the bag has) or cannot
/// be told
BagInputs findInputs(const BagReader& bag, const TopicsConfig& topics,
                     const slam::FramesConfig& frames, const std::vector<Remap>& remaps);

/// The handlers that feed the sinks; for BagReader::read().
BagHandlers handlersFor(const BagInputs& inputs, const InputSinks& sinks);

bool holdsTransforms(const BagTopic& topic);

/// The transforms that do not lead from the map; those are the back-end's to publish.
tf2_msgs::TFMessage withoutMap(const tf2_msgs::TFMessage& message, const std::string& map_frame);

/// All of the bag's /tf_static, the newest of each child frame; none from the map.
tf2_msgs::TFMessage staticTransforms(const BagReader& bag, const std::string& map_frame);

}  // namespace slam_ros
