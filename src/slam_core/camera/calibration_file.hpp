// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/camera/camera_calibration.hpp"

namespace slam {

/// Reads a calibration file as ROS's camera calibration writes it: image_width, image_height,
/// camera_matrix/data (9 numbers), distortion_model, distortion_coefficients/data.
/// @throw ConfigError naming the file and what is missing or wrong
CameraCalibration loadCalibrationFile(const std::string& path);

}  // namespace slam
