// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace slam_ros {

/// The 8 bit grey pixels of a JPEG, PNG or another picture that OpenCV reads, in the order in which
/// the camera has them: a rotation for viewers is ignored. Empty if the bytes are no picture.
///
/// OpenCV's codecs load GDAL and a hundred more libraries, with which a program takes four times as
/// long to start. So this function is in a library of its own, which is loaded for the first
/// picture.
/// @throws std::runtime_error if that library cannot be loaded
cv::Mat decodedGray(const std::vector<std::uint8_t>& data);

}  // namespace slam_ros
