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

/// The content of a bag.
struct BagContents {
  std::vector<BagTopic> topics;  ///< sorted by name
  ros::Time begin, end;
};

/// ROS's library for bags trusts the lengths and offsets in a bag: with a damaged bag it crashes,
/// or takes all memory. So it is called only in a process of its own, which passes on what it
/// reads. Both functions throw std::runtime_error with what is wrong, as a clause to follow the
/// bag's name.
BagContents contentsOfBag(const std::string& path);

/// Reads the messages of the topics in the order of their receipt, until `take` returns false.
void readBag(const std::string& path, const std::vector<std::string>& topics,
             const std::function<bool(const BagMessage&)>& take);

}  // namespace slam_ros
