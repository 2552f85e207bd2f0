// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
#include <slam_msgs/Motion.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "slam_ros/conversions.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/part_node.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/transform_publisher.hpp"

namespace slam_frontend {
namespace {

constexpr std::uint32_t kMotionQueue = 1000;

struct NodeletConfig {
  static constexpr const char* kSection = "";

  bool publish_tf = false;

  void describe(slam::Fields& fields) {
    fields.add("publish_tf", &publish_tf, "also the odometry's transform, where no driver does it");
  }
};

}  // namespace

/// What the product's odometry source takes in, such as `odom` or the transform odom -> base where
/// that is all; `motion` out.
class WheelOdometryNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] {
      publish_tf_ = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle()).publish_tf;
      node_.emplace(slam_ros::PartNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
                    slam::ProductPart{slam::ProductPart::Extent::kOdometry, ""},
                    slam_ros::InputOptions{slam_ros::ImageTransport::kAuto, !publish_tf_, false});
      node_->onceConnected([this] {
        motion_ =
            getNodeHandle().advertise<slam_msgs::Motion>(node_->topics().motion, kMotionQueue);
      });
      node_->part().listen<slam::Motion>("motion", [this](const auto& motion) { publish(motion); });
    });
  }

  void publish(const slam::Motion& motion) {
    if (motion_) motion_.publish(boost::make_shared<slam_msgs::Motion>(slam_ros::toMsg(motion)));
    if (publish_tf_)
      transform_.publish(slam_ros::toRos(motion.end), motion.odometry_frame, motion.base_frame,
                         motion.odometry_end);
  }

  slam_ros::TransformPublisher transform_;
  bool publish_tf_ = false;
  ros::Publisher motion_;
  std::optional<slam_ros::PartNode> node_;  // no callback may find what stands above gone
};

}  // namespace slam_frontend

PLUGINLIB_EXPORT_CLASS(slam_frontend::WheelOdometryNodelet, nodelet::Nodelet)
