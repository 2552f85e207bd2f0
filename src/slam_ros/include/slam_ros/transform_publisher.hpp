// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tf2_ros/transform_broadcaster.h>

#include <optional>
#include <string>

#include "slam_core/geometry/pose2.hpp"

namespace slam_ros {

/// Publishes one edge of the tree of transforms, with strictly increasing stamps: listeners warn of
/// repeated ones.
class TransformPublisher {
 public:
  void publish(const ros::Time& stamp, const std::string& parent, const std::string& child,
               const slam::Pose2& T_parent_child);
  void reset() { last_.reset(); }

 private:
  tf2_ros::TransformBroadcaster broadcaster_;
  std::optional<ros::Time> last_;
};

}  // namespace slam_ros
