// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace slam::sim {

/// Radii of the leaves [texels] and their grays [0, 255].
struct LeafRange {
  double smallest, largest;
  double darkest, brightest;
};

/// A picture that looks alike from near and from afar: ellipses and rectangles lie upon one
/// another, their radii of the density r^-3, which makes the picture's statistics the same at every
/// scale between the smallest and the largest (the dead leaves model: Lee, Mumford, Huang
/// 2001). Band-limited to its texels; seamless; CV_32F.
cv::Mat deadLeaves(cv::Size size, const LeafRange& range, std::uint64_t seed);

}  // namespace slam::sim
