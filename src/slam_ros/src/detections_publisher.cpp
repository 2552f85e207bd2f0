// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/detections_publisher.hpp"

#include "slam_ros/conversions.hpp"
#include "slam_ros/image_conversions.hpp"

namespace slam_ros {

DetectionsPublisher::DetectionsPublisher(ros::NodeHandle handle, const std::string& place)
    : publisher_(handle.advertise<sensor_msgs::Image>(place + "detections/image", 2)) {}

void DetectionsPublisher::publish(const slam::ViewDrawer& detector,
                                  const slam::LandmarkObservationArray& array) const {
  publish(detector, array.stamp, array.sensor_frame);
}

void DetectionsPublisher::publish(const slam::ViewDrawer& drawer, slam::Stamp stamp,
                                  const std::string& frame) const {
  if (publisher_.getNumSubscribers() == 0) return;
  const auto drawing = drawer.drawing();
  if (drawing.empty()) return;
  std_msgs::Header header;
  header.stamp = toRos(stamp);
  header.frame_id = frame;
  publisher_.publish(boost::make_shared<sensor_msgs::Image>(toMsg(drawing, header)));
}

}  // namespace slam_ros
