// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <vector>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/detections_publisher.hpp"
#include "slam_ros/estimator_node.hpp"
#include "slam_ros/module_publisher.hpp"
#include "slam_ros/motion_publisher.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"
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
    node_.reset();  // from here on no callback runs
    saveModules();
  }

 private:
  void onInit() override {
    reportFailure(getName(), [this] {
      const auto config = parametersFromRos<InprocessConfig>(getPrivateNodeHandle());
      output_dir_ = config.outputs.output_dir;
      const auto handle = getNodeHandle();
      auto settings = settingsFromRos(handle);
      slam::ProductConfig product;
      slam::readProduct(settings, product);
      const auto source = slam::createComponents(product).odometry;
      const bool has_own_frame = source && slam::ownsOdometryEdge(*source);
      node_ = std::make_unique<EstimatorNode>(
          EstimatorNode::Handles{handle, getPrivateNodeHandle(), getName()}, config.outputs,
          product_, slam::ProductPart(),
          InputOptions{config.camera.transport, !config.publish_tf || has_own_frame,
                       config.publish_tf});
      showDetections();
      showMotion(config.publish_tf);
      showModules(config.outputs.points_rate);
    });
  }

  void showDetections() {
    for (const auto& [place, detector] : product_.components().detectors) {
      const auto* drawer = drawerOf(detector.get());
      if (drawer == nullptr) continue;
      const DetectionsPublisher detections(getNodeHandle(), place.prefix());
      product_.listen<slam::LandmarkObservationArray>(
          place.observations(),
          [detections, drawer](const auto& array) { detections.publish(*drawer, array); });
    }
  }

  /// What an odometry source with a frame of its own makes is shown; of others only the transform.
  void showMotion(bool with_tf) {
    const auto* source = product_.components().odometry.get();
    const bool is_shown = source != nullptr && !source->name().empty();
    if (!is_shown && with_tf)
      node_->on_step = [this](const slam::StepReport& report) {
        odometry_transform_.publish(toRos(report.stamp), report.odometry_frame, report.base_frame,
                                    report.odometry_pose);
      };
    if (!is_shown) return;
    shown_motion_.emplace(getNodeHandle(), *source);
    product_.listen<slam::Motion>("motion", [this, with_tf](const slam::Motion& motion) {
      if (with_tf)
        odometry_transform_.publish(toRos(motion.end), motion.odometry_frame, motion.base_frame,
                                    motion.odometry_end);
      shown_motion_->publish(motion);
    });
  }

  void showModules(double rate) {
    const ModulePublisher::Context context{getNodeHandle(),
                                           frameId(product_.components().frames.map), rate};
    for (const auto& [name, module] : product_.components().modules)
      if (auto publisher = ModulePublishers::instance().create(*module, context))
        modules_.push_back(std::move(publisher));
    node_->on_idle = [this] {
      for (const auto& module : modules_) module->update();
    };
  }

  void saveModules() {
    if (output_dir_.empty()) return;
    try {
      for (const auto& [name, module] : product_.components().modules) module->save(output_dir_);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM(error.what());
    }
  }

  /// Null where there is nothing to see.
  static const slam::ViewDrawer* drawerOf(const slam::Component* component) {
    return dynamic_cast<const slam::ViewDrawer*>(component);
  }

  slam::MetaCoordinator product_;
  TransformPublisher odometry_transform_;
  std::optional<MotionPublisher> shown_motion_;
  std::vector<std::unique_ptr<ModulePublisher>> modules_;
  std::string output_dir_;
  std::unique_ptr<EstimatorNode> node_;
};

}  // namespace slam_ros

PLUGINLIB_EXPORT_CLASS(slam_ros::InprocessNodelet, nodelet::Nodelet)
