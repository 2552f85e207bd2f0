// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>

#include "slam_ros/bag_reader.hpp"

namespace slam_ros {

bool holdsTransforms(const BagTopic& topic);

/// The transforms that do not lead from the map; those are the back-end's to publish.
tf2_msgs::TFMessage withoutMap(const tf2_msgs::TFMessage& message, const std::string& map_frame);

tf2_msgs::TFMessage withoutEdge(const tf2_msgs::TFMessage& message, const std::string& parent,
                                const std::string& child);

/// All of the bag's /tf_static, the newest of each child frame; none from the map.
tf2_msgs::TFMessage staticTransforms(const BagReader& bag, const std::string& map_frame);

/// The topic among the bag's /tf that holds the odometry's transform; empty where none does.
std::string findOdometryEdge(const BagReader& bag, const std::string& odom_frame,
                             const std::string& base_frame);

/// That transform as odometry; one that is sent again with the same stamp tells nothing new.
BagHandler odometryOfEdge(const std::string& odom_frame, const std::string& base_frame,
                          const std::function<void(const nav_msgs::Odometry&)>& sink);

}  // namespace slam_ros
