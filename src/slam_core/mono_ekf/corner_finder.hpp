// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace slam::mono_ekf {

/// The best corners of an image (Shi and Tomasi 1994), apart from one another and from what is
/// there already: strongest first.
/// @param occupied pixels of the features that are in the image
/// @param least_gradient in each direction [1 of 255 per px] @param spacing [px]
/// @param border of the image that is left out [px]
std::vector<Eigen::Vector2d> cornersOf(const cv::Mat& gray,
                                       const std::vector<Eigen::Vector2d>& occupied,
                                       double least_gradient, int spacing, int border);

}  // namespace slam::mono_ekf
