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
    const slam::CameraMount edge_as_mount{edge.child_frame_id, fromMsg(edge.transform)};
    faulty_.erase(edge.child_frame_id);
    if (slam::faultOf(edge_as_mount).empty())
      tree_.setTransform(edge, "tf_static", true);
    else
      faulty_.emplace(edge.child_frame_id, edge_as_mount);
  }
}

std::optional<slam::CameraMount> StaticTransforms::mount(const std::string& base_frame,
                                                         const std::string& camera_frame) const {
  if (const auto faulty = faulty_.find(camera_frame); faulty != faulty_.end())
    return faulty->second;
  const bool is_known =
      !camera_frame.empty() && tree_.canTransform(base_frame, camera_frame, ros::Time());
  if (!is_known) return std::nullopt;
  const auto edge = tree_.lookupTransform(base_frame, camera_frame, ros::Time());
  return slam::CameraMount{camera_frame, fromMsg(edge.transform)};
}

}  // namespace slam_ros
