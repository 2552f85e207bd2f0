// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace slam::sim {

// Pictures of whole walls and doors, as opposed to what repeats: gray, 8 bit, top row first.

constexpr double kPaintedTexelsPerMetre = 256.0;
constexpr double kMostPaintedTexels = 8192.0;  ///< in one direction; longer walls are coarser

double paintedTexelsPerMetre(double width, double height);  ///< of a wall of that size [m]

/// Posters of all sizes on stained plaster, no two alike.
cv::Mat posterWall(double width, double height, std::uint64_t seed);
/// One picture all over.
cv::Mat muralWall(double width, double height, std::uint64_t seed);
/// A door; those of one size are all alike.
cv::Mat doorLeaf(double width, double height);

}  // namespace slam::sim
