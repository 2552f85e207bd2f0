// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace slam_ros {

/// The 8 bit grey pixels of a JPEG, PNG or another picture that OpenCV reads, as the camera has
/// them, whatever way up a viewer should show them; empty where the bytes are no picture.
///
/// OpenCV's codecs bring GDAL and a hundred further libraries, with which a program takes four
/// times as long to start. So they are a library of their own, loaded for the first picture.
/// @throws std::runtime_error where that library cannot be loaded
cv::Mat decodedGray(const std::vector<std::uint8_t>& data);

}  // namespace slam_ros
