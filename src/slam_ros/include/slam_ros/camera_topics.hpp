// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam_ros {

/// The topics of one camera, named as image_transport does.
struct CameraTopics {
  std::string raw;         ///< sensor_msgs/Image
  std::string compressed;  ///< sensor_msgs/CompressedImage
  std::string info;        ///< sensor_msgs/CameraInfo
};

/// @param image the raw or the compressed topic
inline CameraTopics cameraTopics(std::string image) {
  const std::string suffix = "/compressed";
  if (image.size() > suffix.size() &&
      image.compare(image.size() - suffix.size(), suffix.size(), suffix) == 0)
    image.resize(image.size() - suffix.size());
  const auto slash = image.rfind('/');
  const auto folder = slash == std::string::npos ? "" : image.substr(0, slash + 1);
  return {image, image + suffix, folder + "camera_info"};
}

}  // namespace slam_ros
