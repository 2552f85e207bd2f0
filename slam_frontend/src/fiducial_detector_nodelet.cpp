// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
#include <slam_msgs/LandmarkObservationArray.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/detections_publisher.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/part_node.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_frontend {

/// What the product's detector takes in, such as images or scans; `observations` out.
class FiducialDetectorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] {
      const auto transport =
          slam_ros::parametersFromRos<slam_ros::TransportConfig>(getPrivateNodeHandle()).transport;
      node_.emplace(slam_ros::PartNode::Handles{getNodeHandle(), getPrivateNodeHandle(), getName()},
                    slam::ProductPart{slam::ProductPart::Extent::kDetector, ""},
                    slam_ros::InputOptions{transport, true, false});
      const auto* detector = node_->part().components().detector.get();
      if (detector == nullptr) {
        NODELET_INFO("the product looks at no images");
        return;
      }
      drawer_ = dynamic_cast<const slam::ViewDrawer*>(detector);
      observations_ = getNodeHandle().advertise<slam_msgs::LandmarkObservationArray>(
          node_->topics().observations, slam_ros::kQueue);
      detections_.emplace(getNodeHandle());
      node_->part().listen<slam::LandmarkObservationArray>(
          "observations", [this](const auto& array) { publish(array); });
    });
  }

  void publish(const slam::LandmarkObservationArray& array) {
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
