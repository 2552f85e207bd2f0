// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/aruco.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "bag_maker.hpp"

namespace slam_ros::test {

constexpr double kFocalLength = 400;  // [px]
constexpr int kImageWidth = 320, kImageHeight = 240;
constexpr double kMarkerX = 6.0, kMarkerY = 0.3, kMarkerSize = 0.4;  // [m]
constexpr int kMarkerId = 7;                                         // of DICT_4X4_50

/// What a camera at the robot's origin, looking ahead, sees of the marker from (t, 0).
inline cv::Mat picture(double t) {
  constexpr int kFine = 8;  // subpixels a pixel, whose mean is what a camera gives
  cv::Mat marker, image;
  cv::Mat fine(kFine * kImageHeight, kFine * kImageWidth, CV_8UC1, cv::Scalar(200));
  cv::aruco::drawMarker(cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), kMarkerId, 60,
                        marker);
  // of the marker's black square: u to the right, v down
  const double scale = kFocalLength / (kMarkerX - t);
  const double u = kImageWidth / 2 - scale * kMarkerY, v = kImageHeight / 2;
  const double h = scale * kMarkerSize / 2;
  const auto at = [](double x) { return static_cast<int>(std::lround(kFine * (x + 0.5))); };
  cv::Mat square = fine(cv::Rect(cv::Point(at(u - h), at(v - h)), cv::Point(at(u + h), at(v + h))));
  cv::resize(marker, square, square.size(), 0, 0, cv::INTER_NEAREST);
  cv::resize(fine, image, {kImageWidth, kImageHeight}, 0, 0, cv::INTER_AREA);
  return image;
}

inline std_msgs::Header cameraHeader(double t) {
  std_msgs::Header header;
  header.stamp = at(t);
  header.frame_id = "camera";
  return header;
}

inline sensor_msgs::Image rawImage(double t) {
  const auto pixels = picture(t);
  sensor_msgs::Image message;
  message.header = cameraHeader(t);
  message.encoding = "mono8";
  message.width = message.step = kImageWidth;
  message.height = kImageHeight;
  message.data.assign(pixels.datastart, pixels.dataend);
  return message;
}

inline sensor_msgs::CompressedImage pngImage(double t) {
  sensor_msgs::CompressedImage message;
  message.header = cameraHeader(t);
  message.format = "png";
  cv::imencode(".png", picture(t), message.data);
  return message;
}

inline sensor_msgs::CameraInfo cameraInfo(double t) {
  sensor_msgs::CameraInfo message;
  message.header = cameraHeader(t);
  message.width = kImageWidth;
  message.height = kImageHeight;
  message.distortion_model = "plumb_bob";
  message.D.assign(5, 0.0);
  message.K = {kFocalLength, 0, kImageWidth / 2, 0, kFocalLength, kImageHeight / 2, 0, 0, 1};
  return message;
}

/// x right, y down, z ahead.
inline tf2_msgs::TFMessage cameraMount() {
  auto message = transform("base_link", "camera", 0);
  auto& q = message.transforms[0].transform.rotation;
  q.x = q.z = -0.5;
  q.y = q.w = 0.5;
  return message;
}

/// 10 images a second for `duration`, each with a camera_info unless its topic is empty.
inline void addCamera(BagMaker& bag, const std::string& image, const std::string& info,
                      double duration = 3.5) {
  const bool compressed = image.find("/compressed") != std::string::npos;
  for (int i = 1; i <= 10 * duration; ++i) {
    const double t = 0.1 * i + 0.01;
    if (!info.empty()) bag.add(info, t, cameraInfo(t));
    if (compressed)
      bag.add(image, t, pngImage(t));
    else
      bag.add(image, t, rawImage(t));
  }
}

}  // namespace slam_ros::test
