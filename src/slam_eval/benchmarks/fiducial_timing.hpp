// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>
#include <string>

namespace slam::eval {

/// Ten markers on a wall, as a camera of 640x480 pixels sees them.
cv::Mat tenMarkers();

/// For each detector and setting the median CPU time of a frame [ms], of ours (from the image to
/// the array of observations) and of the bare call, the two taking turns: an array of {detector,
/// setting, image, markers, ours_ms, bare_ms}.
nlohmann::json timeDetectors(const cv::Mat& gray, const std::string& image_name, int repeats);

}  // namespace slam::eval
