// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/fiducial/marker_detection.hpp"

namespace slam::fiducial {

/// An image in colour with the markers drawn into it: accepted ones in green with their id,
/// rejected ones in red with the reason.
cv::Mat draw(const cv::Mat& gray, const std::vector<MarkerDetection>& detections);

}  // namespace slam::fiducial
