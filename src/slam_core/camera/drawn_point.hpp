// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <opencv2/core/types.hpp>

namespace slam {

/// OpenCV draws at whole numbers of 2^-kFractionBits pixels, given as its `shift`.
constexpr int kFractionBits = 4;

/// A pixel in that unit, rounded.
inline cv::Point drawnAt(const Eigen::Vector2d& pixel) {
  return {static_cast<int>(std::lround(pixel.x() * (1 << kFractionBits))),
          static_cast<int>(std::lround(pixel.y() * (1 << kFractionBits)))};
}

}  // namespace slam
