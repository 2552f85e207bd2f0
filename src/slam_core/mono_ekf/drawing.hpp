// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/mono_ekf/active_search.hpp"

namespace slam::mono_ekf {

/// A copy of an image in colour, with an ellipse for each feature where it was searched: green
/// where it was matched, yellow where its depth is not known yet, red where the others do not agree
/// with what was found, grey where nothing was found. Features that begin are blue points.
/// @param gray 8 bit, one channel; else the result is empty
/// @param have_depth of each search, whether its feature is a point in metres
cv::Mat draw(const cv::Mat& gray, const std::vector<Search>& searches,
             const std::vector<bool>& have_depth, const std::vector<Eigen::Vector2d>& added);

}  // namespace slam::mono_ekf
