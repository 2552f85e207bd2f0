// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace slam::sim {

/// A marker as it is printed, one value a cell, upright, its white margin of two cells included.
struct MarkerPattern {
  cv::Mat cells;     ///< square, 8 bit, 0 or 255
  int border_first;  ///< cells from the edge of the paper to the square a detector returns
  int border_cells;  ///< edge of that square [cells]
};

/// @throw std::invalid_argument no such family or id (see markerFamilies())
MarkerPattern markerPattern(const std::string& family, std::int64_t id);

}  // namespace slam::sim
