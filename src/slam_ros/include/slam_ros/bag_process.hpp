// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/time.h>

#include <functional>
#include <string>
#include <vector>

#include "slam_ros/bag_message.hpp"
#include "slam_ros/topic_matching.hpp"

namespace slam_ros {

/// What stands in a bag.
struct BagContents {
  std::vector<BagTopic> topics;  ///< sorted by name
  ros::Time begin, end;
};

/// ROS's library for bags trusts the lengths and places that a bag tells: with a damaged one it
/// crashes, or takes all memory. It is only called in a process of its own, which hands over what
/// it reads. Both throw std::runtime_error with what is wrong, to stand behind the bag's name.
BagContents contentsOfBag(const std::string& path);

/// The messages of the topics, in the order of their receipt, until `take` returns false.
void readBag(const std::string& path, const std::vector<std::string>& topics,
             const std::function<bool(const BagMessage&)>& take);

}  // namespace slam_ros
