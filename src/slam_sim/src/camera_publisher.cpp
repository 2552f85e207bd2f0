// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_publisher.hpp"

#include "sensor_messages.hpp"

namespace slam::sim {
namespace {

constexpr std::uint32_t kImageQueue = 5;

}  // namespace

CameraPublisher::CameraPublisher(ros::NodeHandle handle, const CameraModel& model,
                                 std::size_t index)
    : model_(model), index_(index) {
  const auto image = model.name + "/image_raw";
  info_ = handle.advertise<sensor_msgs::CameraInfo>(model.name + "/camera_info", kImageQueue);
  raw_ = handle.advertise<sensor_msgs::Image>(image, kImageQueue);
  compressed_ = handle.advertise<sensor_msgs::CompressedImage>(image + "/compressed", kImageQueue);
}

bool CameraPublisher::isWanted() const {
  return raw_.getNumSubscribers() > 0 || compressed_.getNumSubscribers() > 0;
}

void CameraPublisher::publish(const ros::Time& stamp, const Sensors& sensors,
                              const BasePath& T_world_base, double time) {
  const std::unique_lock lock(busy_, std::try_to_lock);
  if (!lock.owns_lock()) return;
  info_.publish(cameraInfoMessage(model_, stamp));
  if (!isWanted()) return;
  const auto gray = sensors.image(index_, T_world_base, images_++, time);
  if (raw_.getNumSubscribers() > 0) raw_.publish(imageMessage(model_, stamp, gray));
  if (compressed_.getNumSubscribers() > 0)
    compressed_.publish(compressedMessage(model_, stamp, gray));
}

}  // namespace slam::sim
