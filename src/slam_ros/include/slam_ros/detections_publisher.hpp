// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam_ros {

/// Publishes the annotated image of a detector, or of a back-end that takes in images itself, on a
/// topic of its own. The image is drawn only while somebody has subscribed.
class DetectionsPublisher {
 public:
  /// @param place of the detector, whose prefix the topic `detections/image` gets
  DetectionsPublisher(ros::NodeHandle handle, const std::string& place);

  /// @param array the output of `detector` for its last image
  void publish(const slam::ViewDrawer& detector, const slam::LandmarkObservationArray& array) const;
  /// @param stamp of its last image
  void publish(const slam::ViewDrawer& drawer, slam::Stamp stamp, const std::string& frame) const;

 private:
  ros::Publisher publisher_;
};

}  // namespace slam_ros
