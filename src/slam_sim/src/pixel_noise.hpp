// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>

#include "slam_core/common/random.hpp"

namespace slam::sim {

/// Gray values, noise added, rounded and clamped to 8 bit. Gaussian noise to 3.5 standard
/// deviations, drawn from a table of its quantiles: 16 random bits a pixel.
/// @param gray CV_32F
cv::Mat withPixelNoise(const cv::Mat& gray, double sigma, RandomStream random);

}  // namespace slam::sim
