// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/sensor_mount.hpp"

#include <utility>

#include "slam_core/geometry/mount.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/image_conversions.hpp"

namespace slam_ros {

SensorMount::SensorMount(std::string base_frame, Sink sink)
    : base_frame_(std::move(base_frame)), sink_(std::move(sink)) {}

void SensorMount::take(const tf2_msgs::TFMessage& static_transforms) {
  for (auto edge : static_transforms.transforms) {
    edge.header.frame_id = frameId(edge.header.frame_id);
    edge.child_frame_id = frameId(edge.child_frame_id);
    const auto edge_as_mount = fromMsg(edge.transform);
    faulty_.erase(edge.child_frame_id);
    if (slam::faultOfMount(edge_as_mount).empty())
      tree_.setTransform(edge, "tf_static", true);
    else
      faulty_.emplace(edge.child_frame_id, edge_as_mount);
  }
  tell();
}

void SensorMount::takeFrame(const std::string& sensor_frame) {
  if (frame_ == sensor_frame) return;
  frame_ = sensor_frame;
  tell();
}

std::optional<Eigen::Isometry3d> SensorMount::pose() const {
  if (!frame_) return std::nullopt;
  if (const auto faulty = faulty_.find(*frame_); faulty != faulty_.end()) return faulty->second;
  const bool is_known = !frame_->empty() && tree_.canTransform(base_frame_, *frame_, ros::Time());
  if (!is_known) return std::nullopt;
  return fromMsg(tree_.lookupTransform(base_frame_, *frame_, ros::Time()).transform);
}

void SensorMount::tell() {
  const auto known = pose();
  const bool is_old =
      known && told_ && told_frame_ == *frame_ && told_->matrix() == known->matrix();
  if (!known || is_old) return;
  told_ = known;
  told_frame_ = *frame_;
  sink_(*frame_, *known);
}

std::string SensorMount::missing() const {
  if (!frame_ || (told_ && told_frame_ == *frame_)) return "";
  return base_frame_ + " -> " + (frame_->empty() ? "(no frame)" : *frame_);
}

std::string SensorMount::lackInBag() const {
  if (!told_)
    return missing().empty() ? "" : "the bag's /tf_static does not tell the transform " + missing();
  const auto fault = slam::faultOfMount(*told_);
  return fault.empty() ? ""
                       : "the transform " + base_frame_ + " -> " + told_frame_ +
                             " of the bag's /tf_static cannot be used: " + fault;
}

}  // namespace slam_ros
