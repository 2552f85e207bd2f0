// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>

namespace slam::mono_ekf {

/// The surroundings of a corner, coarse enough to be compared without knowing to a pixel where it
/// is (Brown, Szeliski and Winder 2005, without the rotation, since the robot does not roll): 8 x 8
/// samples of a smoothed image, of mean 0 and length 1. The product of two is their correlation.
using PatchDescriptor = Eigen::Matrix<float, 64, 1>;

/// The samples of a descriptor are taken from this smoothed image.
cv::Mat smoothed(const cv::Mat& gray);
/// The result is empty if the image ends too near, or if it shows hardly any contrast.
/// @param smooth the smoothed image @param scale how much larger the surroundings are taken
std::optional<PatchDescriptor> describe(const cv::Mat& smooth, const Eigen::Vector2d& pixel,
                                        double scale);

}  // namespace slam::mono_ekf
