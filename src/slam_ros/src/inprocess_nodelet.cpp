// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "slam_core/point_map/pcd_file.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/camera_subscriber.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/detections_publisher.hpp"
#include "slam_ros/estimator_node.hpp"
#include "slam_ros/motion_publisher.hpp"
#include "slam_ros/odometry_subscriber.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/points_publisher.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_ros {
namespace {

struct InprocessConfig {
  static constexpr const char* kSection = "";

  OutputsConfig outputs;
  TransportConfig camera;
  bool publish_tf = false;

  void describe(slam::Fields& fields) {
    outputs.describe(fields);
    camera.describe(fields);
    fields.add("publish_tf", &publish_tf, "also the odometry's transform, where no driver does it");
  }
};

}  // namespace

/// Composition inprocess: the whole product in one nodelet.
class InprocessNodelet : public nodelet::Nodelet {
 public:
  ~InprocessNodelet() override {
    // inputs first: no callback may find what it needs gone
    start_.reset();
    if (odom_) odom_->shutdown();
    for (auto* camera : {&camera_, &ceiling_camera_})
      if (*camera) (*camera)->stop();
    node_.reset();
    savePoints();
  }

 private:
  void onInit() override {
    reportFailure(getName(), [this] {
      const auto config = parametersFromRos<InprocessConfig>(getPrivateNodeHandle());
      output_dir_ = config.outputs.output_dir;
      node_ = std::make_unique<EstimatorNode>(
          EstimatorNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
          config.outputs, product_);
      const bool looks_up = product_.coordinator().odometry().usesImages();
      if (config.publish_tf && !looks_up)
        node_->on_step = [this](const slam::StepReport& report) {
          odometry_transform_.publish(toRos(report.stamp), report.odometry_frame, report.base_frame,
                                      report.odometry_pose);
        };
      if (product_.coordinator().detector() != nullptr) connectCamera(config.camera.transport);
      if (looks_up) connectCeilingCamera(config);
      if (product_.coordinator().pointMap() != nullptr) showPoints(config.outputs.points_rate);
      if (product_.coordinator().odometry().usesWheels()) connectWheels(config);
    });
  }

  void connectWheels(const InprocessConfig& config) {
    const auto& frames = product_.coordinator().frames();
    const bool looks_up = product_.coordinator().odometry().usesImages();
    odom_.emplace(getNodeHandle(),
                  OdometrySubscriber::Options{node_->topics().odom, frames.odom, frames.base,
                                              !config.publish_tf || looks_up, config.publish_tf},
                  [this](const nav_msgs::Odometry& message) { onOdom(message); });
    start_.emplace([this] { odom_->subscribe(); });
  }

  void connectCamera(const std::string& transport) {
    auto& coordinator = product_.coordinator();
    detections_.emplace(getNodeHandle());
    coordinator.on_detections = [this](const slam::LandmarkObservationArray& array) {
      detections_->publish(*product_.coordinator().detector(), array);
    };
    const auto take = [this](const auto& input) {
      node_->checkClock();
      product_.coordinator().set(input);
      node_->takeSteps(camera_->topic());
    };
    camera_.emplace(getNodeHandle(),
                    CameraSubscriber::Options{node_->topics().camera, transport,
                                              frameId(coordinator.frames().base)},
                    CameraInput::Sinks{take, take, take});
    node_->front_end_waiting = [this] { return waiting(); };
  }

  void connectCeilingCamera(const InprocessConfig& config) {
    auto& coordinator = product_.coordinator();
    visual_motion_.emplace(getNodeHandle());
    coordinator.on_motion = [this, with_tf = config.publish_tf](const slam::Motion& motion) {
      if (with_tf)
        odometry_transform_.publish(toRos(motion.end), motion.odometry_frame, motion.base_frame,
                                    motion.odometry_end);
      visual_motion_->publish(motion);
      visual_motion_->show(product_.coordinator().odometry(), motion.end);
    };
    const auto take = [this](const auto& input) {
      node_->checkClock();
      product_.coordinator().setForOdometry(input);
      node_->takeSteps(ceiling_camera_->topic());
    };
    ceiling_camera_.emplace(
        getNodeHandle(),
        CameraSubscriber::Options{node_->topics().ceiling_camera, config.camera.transport,
                                  frameId(coordinator.frames().base)},
        CameraInput::Sinks{take, take, take});
    node_->front_end_waiting = [this] { return waiting(); };
  }

  void showPoints(double rate) {
    const auto& coordinator = product_.coordinator();
    points_.emplace(getNodeHandle(), *coordinator.pointMap(), frameId(coordinator.frames().map),
                    rate);
    node_->on_idle = [this] { points_->update(); };
  }

  void savePoints() {
    if (!points_ || output_dir_.empty()) return;
    try {
      slam::point_map::savePcd(output_dir_ + "/points.pcd",
                               product_.coordinator().pointMap()->points());
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM(error.what());
    }
  }

  std::string waiting() const {
    for (const auto* camera : {&camera_, &ceiling_camera_})
      if (*camera && !(*camera)->waiting().empty()) return (*camera)->waiting();
    return "";
  }

  void onOdom(const nav_msgs::Odometry& message) {
    const auto& topic = odom_->source();
    node_->checkClock();
    const auto fault = saysNoPose(message) ? "" : poseFault(message);
    if (!fault.empty()) node_->diagnostics().warn(topic + ": " + fault + "; its twist is used");
    product_.coordinator().set(fromMsg(message));
    node_->takeSteps(topic);
  }

  WholeProduct product_;
  TransformPublisher odometry_transform_;
  std::optional<DetectionsPublisher> detections_;
  std::optional<VisualMotionPublisher> visual_motion_;
  std::optional<PointsPublisher> points_;
  std::string output_dir_;
  std::optional<CameraSubscriber> camera_, ceiling_camera_;
  std::unique_ptr<EstimatorNode> node_;
  std::optional<OdometrySubscriber> odom_;
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros

PLUGINLIB_EXPORT_CLASS(slam_ros::InprocessNodelet, nodelet::Nodelet)
