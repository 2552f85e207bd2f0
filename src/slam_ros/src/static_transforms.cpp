// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/static_transforms.hpp"

#include "slam_core/geometry/mount.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/image_conversions.hpp"

namespace slam_ros {

void StaticTransforms::set(const tf2_msgs::TFMessage& message) {
  for (auto edge : message.transforms) {
    edge.header.frame_id = frameId(edge.header.frame_id);
    edge.child_frame_id = frameId(edge.child_frame_id);
    const auto edge_as_mount = fromMsg(edge.transform);
    faulty_.erase(edge.child_frame_id);
    if (slam::faultOfMount(edge_as_mount).empty())
      tree_.setTransform(edge, "tf_static", true);
    else
      faulty_.emplace(edge.child_frame_id, edge_as_mount);
  }
}

std::optional<Eigen::Isometry3d> StaticTransforms::mount(const std::string& base_frame,
                                                         const std::string& sensor_frame) const {
  if (const auto faulty = faulty_.find(sensor_frame); faulty != faulty_.end())
    return faulty->second;
  const bool is_known =
      !sensor_frame.empty() && tree_.canTransform(base_frame, sensor_frame, ros::Time());
  if (!is_known) return std::nullopt;
  return fromMsg(tree_.lookupTransform(base_frame, sensor_frame, ros::Time()).transform);
}

std::string lackOfTransform(const std::string& missing) {
  return missing.empty() ? "" : "the bag's /tf_static does not tell the transform " + missing;
}

}  // namespace slam_ros
