// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam_core/grid_map/grid_map_config.hpp"
#include "slam_core/grid_map/tile.hpp"

namespace slam::grid_map {

/// What a beam says of the cells that it passes and ends in (Moravec, Elfes 1985; Thrun, Burgard,
/// Fox 2005, ch. 9.2), and how likely an end is beside what it met (the likelihood field of ch.
/// 6.4).
class BeamModel {
 public:
  static constexpr double kSigmas = 3.0;  ///< within which an end lies of what it met

  BeamModel() : BeamModel(GridMapConfig()) {}
  /// @param config is valid
  explicit BeamModel(const GridMapConfig& config);

  double resolution() const { return resolution_; }
  double usableRange() const { return usable_range_; }
  double freeRange() const { return free_range_; }
  LogOdds largestLogOdds() const { return largest_; }

  /// What a cell gains in which a beam ends, at least 1. A beam counts as a whole while its end
  /// lies within half a cell of what it met, and in proportion to its information beyond.
  /// @param sigma of its range [m]
  LogOdds gainOf(double sigma) const;
  LogOdds afterHit(LogOdds cell, LogOdds gain) const {
    return static_cast<LogOdds>(std::min((cell == kUnseen ? 0 : cell) + gain, int{largest_}));
  }
  LogOdds afterMiss(LogOdds cell) const { return after_miss_[index(cell)]; }
  static bool isOccupied(LogOdds cell) { return cell > 0; }

  /// Cells around an end to which its likelihood reaches.
  int reach() const { return reach_; }
  /// exp(-d^2 / 2 sigma^2) along one axis: the middle of the cell `cells` away from that of an end
  /// which lies `offset` [1/256 cell] from the middle of its own.
  float alongAxis(int cells, std::int8_t offset) const {
    return kernel_[static_cast<std::size_t>((cells + reach_) * kOffsets + offset + kOffsets / 2)];
  }

 private:
  static constexpr int kOffsets = 256;
  static std::size_t index(LogOdds cell) { return static_cast<std::uint8_t>(cell); }

  double resolution_, usable_range_, free_range_;
  LogOdds hit_, largest_;
  std::array<LogOdds, 256> after_miss_;
  int reach_;
  std::vector<float> kernel_;
};

}  // namespace slam::grid_map
