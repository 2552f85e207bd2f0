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
  if (publisher_.getNumSubscribers() == 0) return;
  const auto drawing = detector.drawing();
  if (drawing.empty()) return;
  std_msgs::Header header;
  header.stamp = toRos(array.stamp);
  header.frame_id = array.sensor_frame;
  publisher_.publish(boost::make_shared<sensor_msgs::Image>(toMsg(drawing, header)));
}

}  // namespace slam_ros
