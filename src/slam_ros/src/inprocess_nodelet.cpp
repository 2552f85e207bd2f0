// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "slam_ros/conversions.hpp"
#include "slam_ros/estimator_node.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/report_failure.hpp"

namespace slam_ros {
namespace {

struct InprocessConfig {
  static constexpr const char* kSection = "";

  OutputsConfig outputs;
  bool publish_tf = false;

  void describe(slam::Fields& fields) {
    outputs.describe(fields);
    fields.add("publish_tf", &publish_tf, "also the odometry's transform, where no driver does it");
  }
};

}  // namespace

/// Composition inprocess: the whole product in one nodelet.
class InprocessNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    reportFailure(getName(), [this] {
      const auto config = parametersFromRos<InprocessConfig>(getPrivateNodeHandle());
      node_ = std::make_unique<EstimatorNode>(
          EstimatorNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
          config.outputs, product_);
      if (config.publish_tf)
        node_->on_step = [this](const slam::StepReport& report) {
          odometry_transform_.publish(toRos(report.stamp), report.odometry_frame, report.base_frame,
                                      report.odometry_pose);
        };
      odom_ =
          getNodeHandle().subscribe(node_->topics().odom, 1000, &InprocessNodelet::onOdom, this);
    });
  }

  void onOdom(const nav_msgs::Odometry& message) {
    const auto& topic = node_->topics().odom;
    node_->checkClock();
    const auto fault = saysNoPose(message) ? "" : poseFault(message);
    if (!fault.empty()) node_->diagnostics().warn(topic + ": " + fault + "; its twist is used");
    product_.set(fromMsg(message));
    node_->takeSteps(topic);
  }

  WholeProduct product_;
  TransformPublisher odometry_transform_;
  std::unique_ptr<EstimatorNode> node_;
  ros::Subscriber odom_;  // after node_: no callback may find it gone
};

}  // namespace slam_ros

PLUGINLIB_EXPORT_CLASS(slam_ros::InprocessNodelet, nodelet::Nodelet)
