// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tf2_msgs/TFMessage.h>

#include <string>

#include "slam_ros/bag_reader.hpp"

namespace slam_ros {

/// The transforms except those from the map frame, which the back-end publishes.
tf2_msgs::TFMessage withoutMap(const tf2_msgs::TFMessage& message, const std::string& map_frame);

tf2_msgs::TFMessage withoutEdge(const tf2_msgs::TFMessage& message, const std::string& parent,
                                const std::string& child);

/// All of the bag's /tf_static, the newest of each child frame; none from the map.
tf2_msgs::TFMessage staticTransforms(const BagReader& bag, const std::string& map_frame);

}  // namespace slam_ros
