// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace slam {

/// A grid of occupancy probabilities as it is shown, saved and loaded. Its axes are those of the
/// map frame.
struct OccupancyGrid {
  static constexpr std::int8_t kUnknown = -1;

  double resolution = 0.0;                           ///< edge of a cell [m]
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< corner of cell (0, 0), least x and y [m]
  std::uint32_t width = 0, height = 0;               ///< in cells, along x and y
  /// Row by row from the least y: percent of certainty that the cell is occupied, or kUnknown.
  std::vector<std::int8_t> cells;

  template <class Archive>
  void persist(Archive& archive) {
    archive(resolution, origin, width, height, cells);
  }
};

}  // namespace slam
