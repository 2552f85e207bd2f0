// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "motion_outputs.hpp"
#include "nodelet_config.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/part_node.hpp"
#include "slam_ros/report_failure.hpp"

namespace slam_visual_odometry {

/// Images of the ceiling in, and the wheels' `odom` where the product wants them; `motion` out.
class VisualOdometryNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] {
      const auto config = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
      const auto* name = config.publish_motion ? "" : "visual";  // beside what the product names
      node_.emplace(slam_ros::PartNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
                    slam::ProductPart{slam::ProductPart::Extent::kOdometry, name},
                    slam_ros::InputOptions{config.camera.transport, true, true});
      auto& part = node_->part();
      outputs_.emplace(
          getNodeHandle(), config, part.components().frames, node_->topics().motion,
          [this](const std::string& sentence) { node_->diagnostics().warn(sentence); });
      node_->on_reset = [this] { outputs_->reset(); };
      part.listen<slam::Motion>("motion", [this](const auto& motion) {
        outputs_->publish(motion, node_->part().components().odometry.get());
        node_->noteOutput();
      });
    });
  }

  std::optional<MotionOutputs> outputs_;
  std::optional<slam_ros::PartNode> node_;  // no callback may find what stands above gone
};

}  // namespace slam_visual_odometry

PLUGINLIB_EXPORT_CLASS(slam_visual_odometry::VisualOdometryNodelet, nodelet::Nodelet)
