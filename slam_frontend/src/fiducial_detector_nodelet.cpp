// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
#include <slam_msgs/LandmarkObservationArray.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/detections_publisher.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/part_node.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_frontend {

struct DetectorNodeletConfig {
  static constexpr const char* kSection = "";

  slam_ros::TransportConfig camera;
  std::string place;

  void describe(slam::Fields& fields) {
    camera.describe(fields);
    fields.add("place", &place,
               "which of the product's detectors it is: second_, rear_, rear_second_; empty: the "
               "first one");
  }
};

/// Runs one of the product's detectors: it takes in images or scans, and publishes observations.
class FiducialDetectorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] {
      const auto config =
          slam_ros::parametersFromRos<DetectorNodeletConfig>(getPrivateNodeHandle());
      node_.emplace(slam_ros::PartNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
                    slam::ProductPart{slam::ProductPart::Extent::kDetector, "", config.place},
                    slam_ros::InputOptions{config.camera.transport, true, false});
      const auto& detectors = node_->part().components().detectors;
      if (detectors.empty()) {
        NODELET_INFO("the product has no detector here");
        return;
      }
      publish(detectors.front());
    });
  }

  void publish(const slam::ProductDetector& detector) {
    const auto name = detector.place.observations();
    drawer_ = dynamic_cast<const slam::ViewDrawer*>(detector.component.get());
    node_->onceConnected([this, topic = node_->topics().of(name)] {
      observations_ =
          getNodeHandle().advertise<slam_msgs::LandmarkObservationArray>(topic, slam_ros::kQueue);
    });
    detections_.emplace(getNodeHandle(), detector.place.prefix());
    node_->part().listen<slam::LandmarkObservationArray>(
        name, [this](const auto& array) { publish(array); });
  }

  void publish(const slam::LandmarkObservationArray& array) {
    if (observations_)
      observations_.publish(
          boost::make_shared<slam_msgs::LandmarkObservationArray>(slam_ros::toMsg(array)));
    node_->noteOutput();
    if (drawer_ != nullptr) detections_->publish(*drawer_, array);
  }

  ros::Publisher observations_;
  std::optional<slam_ros::DetectionsPublisher> detections_;
  const slam::ViewDrawer* drawer_ = nullptr;  ///< of what the detector saw, where it can
  std::optional<slam_ros::PartNode> node_;    // no callback may find what stands above gone
};

}  // namespace slam_frontend

PLUGINLIB_EXPORT_CLASS(slam_frontend::FiducialDetectorNodelet, nodelet::Nodelet)
