// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <vector>

/// decodedGray() of image_decoder.hpp calls this.
extern "C" void slam_ros_decode_gray(const std::vector<std::uint8_t>& data, cv::Mat& gray) {
  try {
    gray = cv::imdecode(data, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    gray.release();
  }
}
