// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>
#include <slam_msgs/Progress.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/part_node.hpp>
#include <slam_ros/queue_sizes.hpp>
#include <slam_ros/report_failure.hpp>
#include <string>

namespace slam_map_toy {

/// What the module takes in; its file at the end.
class ToyNodelet final : public nodelet::Nodelet {
 public:
  ~ToyNodelet() override {
    reset_.shutdown();
    if (!node_) return;
    node_->stop();  // no callback may find what it needs gone
    save();
  }

 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] {
      auto handle = getNodeHandle();
      output_dir_ = getPrivateNodeHandle().param("output_dir", std::string());
      node_.emplace(slam_ros::PartNode::Handles{handle, getPrivateNodeHandle(), getName()},
                    slam::ProductPart{slam::ProductPart::Extent::kModule, "map_toy"},
                    slam_ros::InputOptions());
      reset_ = slam_ros::subscribeThrough<slam_msgs::Progress>(
          node_->pass(), handle, "progress", slam_ros::kQueue,
          [this](const auto& progress) { onProgress(progress); });
    });
  }

  /// The back-end was reset or has loaded a map: its poses are those of another map.
  void onProgress(const slam_msgs::Progress& message) {
    if (message.resets != resets_) node_->reset();
    resets_ = message.resets;
  }

  void save() {
    if (output_dir_.empty()) return;
    try {
      node_->part().components().modules.at("map_toy")->save(output_dir_);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM(error.what());
    }
  }

  std::string output_dir_;
  std::optional<slam_ros::PartNode> node_;
  ros::Subscriber reset_;
  std::uint32_t resets_ = 0;  ///< of the back-end
};

}  // namespace slam_map_toy

PLUGINLIB_EXPORT_CLASS(slam_map_toy::ToyNodelet, nodelet::Nodelet)
