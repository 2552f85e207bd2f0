// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/types.hpp>
#include <optional>

#include "slam_core/camera/ceiling_view.hpp"

namespace slam::ceiling_features {

constexpr std::size_t kRingPixels = 24;

/// The pixels that see a ring about a point of the ceiling, at even distances on it.
/// @param radius [m]
/// @return nothing where an image of this size does not hold all of the ring
std::optional<std::array<Eigen::Vector2d, kRingPixels>> pixelsOfRing(const CeilingView& ceiling,
                                                                     const Eigen::Vector2d& point,
                                                                     double radius,
                                                                     const cv::Size& size);

}  // namespace slam::ceiling_features
