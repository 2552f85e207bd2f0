// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/static_transforms.hpp"

#include "slam_ros/conversions.hpp"
#include "slam_ros/image_conversions.hpp"

namespace slam_ros {

void StaticTransforms::set(const tf2_msgs::TFMessage& message) {
  for (auto edge : message.transforms) {
    edge.header.frame_id = frameId(edge.header.frame_id);
    edge.child_frame_id = frameId(edge.child_frame_id);
    tree_.setTransform(edge, "tf_static", true);
  }
}

std::optional<slam::CameraMount> StaticTransforms::mount(const std::string& base_frame,
                                                         const std::string& camera_frame) const {
  const bool is_known =
      !camera_frame.empty() && tree_.canTransform(base_frame, camera_frame, ros::Time());
  if (!is_known) return std::nullopt;
  const auto edge = tree_.lookupTransform(base_frame, camera_frame, ros::Time());
  return slam::CameraMount{camera_frame, fromMsg(edge.transform)};
}

}  // namespace slam_ros
