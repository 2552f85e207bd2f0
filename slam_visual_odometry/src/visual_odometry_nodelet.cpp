// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "motion_outputs.hpp"
#include "nodelet_config.hpp"
#include "slam_core/product/product_components.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/camera_subscriber.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/latency_window.hpp"
#include "slam_ros/odometry_subscriber.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_visual_odometry {

/// Images of the ceiling in, and the wheels' `odom` where the product wants them; `motion` out.
class VisualOdometryNodelet : public nodelet::Nodelet {
 public:
  ~VisualOdometryNodelet() override {
    // no callback may find what it needs gone
    start_.reset();
    if (camera_) camera_->stop();
    if (odom_) odom_->shutdown();
    diagnostics_.reset();
  }

 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(getNodeHandle()); });
  }

  void initialise(ros::NodeHandle handle) {
    auto settings = slam_ros::settingsFromRos(handle);
    auto product = settings.read<slam::ProductConfig>();
    topics_ = settings.read<slam_ros::TopicsConfig>();
    frames_ = settings.read<slam::FramesConfig>();
    config_ = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
    slam::loadLibraries(product.libraries);
    if (!config_.publish_motion) product.odometry = "visual";  // beside what the product names
    source_ = slam::makeOdometry(product);
    source_->configure(settings);
    source_->seed(product.seed);
    outputs_.emplace(handle, config_, frames_, topics_.motion,
                     [this](const std::string& sentence) { diagnostics_->warn(sentence); });
    diagnostics_.emplace(
        handle, getPrivateNodeHandle(), getName(),
        slam_ros::Diagnostics::Sources{[this] { return source_->counters(); },
                                       [this] { return waiting(); }, [this] { return figures(); }});
    connectCamera(handle);
    if (source_->usesWheels()) connectWheels(handle);
  }

  void connectCamera(ros::NodeHandle handle) {
    const auto take = [this](const auto& input) { this->take(input, camera_->topic()); };
    camera_.emplace(
        handle,
        slam_ros::CameraSubscriber::Options{topics_.ceiling_camera, config_.camera.transport,
                                            slam_ros::frameId(frames_.base)},
        slam_ros::CameraInput::Sinks{take, take, take});
  }

  void connectWheels(ros::NodeHandle handle) {
    odom_.emplace(
        handle,
        slam_ros::OdometrySubscriber::Options{topics_.odom, frames_.odom, frames_.base, true, true},
        [this](const nav_msgs::Odometry& message) { onOdom(message); });
    start_.emplace([this] { odom_->subscribe(); });
  }

  void onOdom(const nav_msgs::Odometry& message) {
    const auto fault = slam_ros::saysNoPose(message) ? "" : slam_ros::poseFault(message);
    if (!fault.empty()) diagnostics_->warn(odom_->source() + ": " + fault + "; its twist is used");
    auto sample = slam_ros::fromMsg(message);
    frames_.complete(sample.odometry_frame, sample.base_frame);
    take(sample, odom_->source());
  }

  template <class Input>
  void take(const Input& input, const std::string& topic) {
    if (clock_.hasJumpedBack()) {
      source_->reset();
      outputs_->reset();
    }
    source_->set(input);
    do {
      diagnostics_->report(topic, source_->execute());
      if (source_->motion()) publish();
    } while (source_->isBusy());
  }

  void publish() {
    outputs_->publish(*source_->motion(), *source_);
    latency_.add(camera_->arrival(), slam_ros::LatencyWindow::Clock::now());
  }

  std::string waiting() const {
    const auto wait = camera_->waiting();
    return wait.empty() && odom_ ? odom_->waiting() : wait;
  }

  std::vector<std::pair<std::string, std::string>> figures() const {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const auto& [name, value] : source_->figures())
      texts.emplace_back(name, fmt::format("{:.4g}", value));
    if (latency_.empty()) return texts;
    texts.emplace_back("rate [1/s]", fmt::format("{:.2f}", latency_.rate()));
    texts.emplace_back("latency p50 [ms]", fmt::format("{:.2f}", latency_.milliseconds(0.5)));
    texts.emplace_back("latency p99 [ms]", fmt::format("{:.2f}", latency_.milliseconds(0.99)));
    return texts;
  }

  NodeletConfig config_;
  slam_ros::TopicsConfig topics_;
  slam::FramesConfig frames_;
  std::unique_ptr<slam::OdometrySource> source_;
  slam_ros::ClockWatch clock_;
  slam_ros::LatencyWindow latency_;
  std::optional<MotionOutputs> outputs_;
  std::optional<slam_ros::OdometrySubscriber> odom_;
  std::optional<slam_ros::AfterLoad> start_;
  std::optional<slam_ros::CameraSubscriber> camera_;
  std::optional<slam_ros::Diagnostics> diagnostics_;
};

}  // namespace slam_visual_odometry

PLUGINLIB_EXPORT_CLASS(slam_visual_odometry::VisualOdometryNodelet, nodelet::Nodelet)
