// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/ceiling_features/feature_selection.hpp"

namespace slam::ceiling_features {

/// A copy in colour with a green ring about each landmark and a red point on each other spot.
/// @param gray 8 bit, one channel; else the result is empty
cv::Mat draw(const cv::Mat& gray, const std::vector<CeilingFeature>& features);

}  // namespace slam::ceiling_features
