// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <slam_msgs/Motion.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "slam_core/product/product_components.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/odometry_subscriber.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"
#include "slam_ros/topics_config.hpp"
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

/// `odom`, or the transform odom -> base where that is all, in; `motion` out, by the
/// odometry source that the product names.
class WheelOdometryNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(getNodeHandle()); });
  }

  void initialise(ros::NodeHandle handle) {
    auto settings = slam_ros::settingsFromRos(handle);
    const auto product = settings.read<slam::ProductConfig>();
    topics_ = settings.read<slam_ros::TopicsConfig>();
    frames_ = settings.read<slam::FramesConfig>();
    slam::loadLibraries(product.libraries);
    odometry_ = slam::makeOdometry(product);
    odometry_->configure(settings);
    odometry_->seed(product.seed);
    publish_tf_ = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle()).publish_tf;
    diagnostics_.emplace(handle, getPrivateNodeHandle(), getName(),
                         slam_ros::Diagnostics::Sources{[this] { return odometry_->counters(); },
                                                        [this] { return waiting(); }});
    motion_ = handle.advertise<slam_msgs::Motion>(topics_.motion, kMotionQueue);
    odom_.emplace(handle,
                  slam_ros::OdometrySubscriber::Options{topics_.odom, frames_.odom, frames_.base,
                                                        !publish_tf_},
                  [this](const nav_msgs::Odometry& message) { onOdom(message); });
    start_.emplace([this] { odom_->subscribe(); });
  }

  void onOdom(const nav_msgs::Odometry& message) {
    if (clock_.hasJumpedBack()) odometry_->reset();
    const auto fault = slam_ros::saysNoPose(message) ? "" : slam_ros::poseFault(message);
    if (!fault.empty()) diagnostics_->warn(odom_->source() + ": " + fault + "; its twist is used");
    auto sample = slam_ros::fromMsg(message);
    frames_.complete(sample.odometry_frame, sample.base_frame);
    odometry_->set(sample);
    diagnostics_->report(odom_->source(), odometry_->execute());
    if (odometry_->motion()) publish(*odometry_->motion());
  }

  void publish(const slam::Motion& motion) {
    motion_.publish(boost::make_shared<slam_msgs::Motion>(slam_ros::toMsg(motion)));
    if (publish_tf_)
      transform_.publish(slam_ros::toRos(motion.end), motion.odometry_frame, motion.base_frame,
                         motion.odometry_end);
  }

  std::string waiting() const { return odom_ ? odom_->waiting() : ""; }

  std::unique_ptr<slam::OdometrySource> odometry_;
  slam_ros::TopicsConfig topics_;
  slam::FramesConfig frames_;
  slam_ros::ClockWatch clock_;
  slam_ros::TransformPublisher transform_;
  std::optional<slam_ros::Diagnostics> diagnostics_;
  bool publish_tf_ = false;
  ros::Publisher motion_;
  std::optional<slam_ros::OdometrySubscriber> odom_;  // no callback may find what stands above gone
  std::optional<slam_ros::AfterLoad> start_;
};

}  // namespace slam_frontend

PLUGINLIB_EXPORT_CLASS(slam_frontend::WheelOdometryNodelet, nodelet::Nodelet)
