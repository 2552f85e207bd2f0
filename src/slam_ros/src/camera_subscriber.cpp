// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/camera_subscriber.hpp"

#include <utility>

#include "slam_ros/queue_sizes.hpp"

namespace slam_ros {

CameraSubscriber::CameraSubscriber(ros::NodeHandle handle, const Options& options,
                                   CameraInput::Sinks sinks, Pass pass)
    : topics_(cameraTopics(options.topic)),
      pass_(std::move(pass)),
      input_(options.base_frame, std::move(sinks)) {
  for (const auto& topic : {topics_.raw, topics_.compressed, topics_.info})
    handle.resolveName(topic);  // throws now what subscribing would throw later
  start_.emplace([this, handle, transport = options.transport] { subscribe(handle, transport); });
}

void CameraSubscriber::subscribe(ros::NodeHandle handle, const std::string& transport) {
  const std::lock_guard lock(kind_);
  const auto put_in = [this](const auto& message) { input_.take(message); };
  transforms_ = subscribeThrough<tf2_msgs::TFMessage>(pass_, handle, "/tf_static", kQueue, put_in);
  info_ = subscribeThrough<sensor_msgs::CameraInfo>(pass_, handle, topics_.info, kQueue, put_in);
  if (transport != "compressed")
    raw_ = subscribeThrough<sensor_msgs::Image>(pass_, handle, topics_.raw, kImageQueue,
                                                [this](const auto& image) { onImage(image); });
  if (transport != "raw")
    compressed_ = subscribeThrough<sensor_msgs::CompressedImage>(
        pass_, handle, topics_.compressed, kImageQueue,
        [this](const auto& image) { onCompressedImage(image); });
}

void CameraSubscriber::onImage(const sensor_msgs::Image& message) {
  {
    const std::lock_guard lock(kind_);
    compressed_.shutdown();
  }
  take(message);
}

void CameraSubscriber::onCompressedImage(const sensor_msgs::CompressedImage& message) {
  {
    const std::lock_guard lock(kind_);
    raw_.shutdown();
  }
  take(message);
}

template <class Message>
void CameraSubscriber::take(const Message& message) {
  arrival_ = LatencyWindow::Clock::now();
  input_.take(message);
}

void CameraSubscriber::stop() {
  start_.reset();
  for (auto* subscriber : {&raw_, &compressed_, &info_, &transforms_}) subscriber->shutdown();
}

std::string CameraSubscriber::waiting() const {
  if (!input_.hasImage())
    return "waiting for images on " + topics_.raw + " or " + topics_.compressed;
  if (!input_.hasCalibration()) return "waiting for the camera's calibration on " + topics_.info;
  if (const auto transform = input_.missingTransform(); !transform.empty())
    return "waiting for the transform " + transform + " on /tf_static";
  return "";
}

}  // namespace slam_ros
