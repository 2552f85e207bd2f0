// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/ring.hpp"

#include <cmath>

namespace slam::ceiling_features {

std::optional<std::array<Eigen::Vector2d, kRingPixels>> pixelsOfRing(const CeilingView& ceiling,
                                                                     const Eigen::Vector2d& point,
                                                                     double radius,
                                                                     const cv::Size& size) {
  std::array<Eigen::Vector2d, kRingPixels> pixels;
  for (std::size_t i = 0; i < kRingPixels; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / kRingPixels;
    const auto pixel =
        ceiling.toPixel(point + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    if (!pixel || pixel->x() < 0.0 || pixel->y() < 0.0 || pixel->x() > size.width - 1 ||
        pixel->y() > size.height - 1)
      return std::nullopt;
    pixels[i] = *pixel;
  }
  return pixels;
}

}  // namespace slam::ceiling_features
