// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::scan_matching {

/// Resolutions of a map: the fine one, and a coarse one in which the surfaces are seen from further
/// away (Kohlbrecher et al. 2011).
constexpr std::size_t kLevels = 2;
constexpr double kCoarser = 4.0;

/// A scan as each resolution takes it; the finest first.
using ScanLevels = std::array<grid_map::ScanPoints, kLevels>;

/// The same map in several resolutions.
class ScanMap {
 public:
  struct Level {
    grid_map::BeamModel model;
    grid_map::GridMap map;
  };

  /// @param config of the finest, valid
  explicit ScanMap(const grid_map::GridMapConfig& config);
  ScanMap(const ScanMap&) = delete;  // the levels point into the memory
  ScanMap& operator=(const ScanMap&) = delete;

  /// @param spacing of the ends to match in the finest [m]
  ScanLevels pointsOf(const LaserScan& scan, double spacing) const;
  /// @param pose T_map_base
  /// @return beams that end beyond the largest map
  std::size_t insert(const ScanLevels& scan, const Pose2& pose);

  bool isEmpty() const { return finest().map.isEmpty(); }
  const std::array<Level, kLevels>& levels() const { return levels_; }
  const Level& finest() const { return levels_.front(); }
  Level& level(std::size_t i) { return levels_[i]; }
  std::size_t bytes() const { return memory_.bytes(); }

 private:
  static Level levelOf(grid_map::GridMapConfig config, double coarser,
                       grid_map::GridMap::Memory& memory);

  grid_map::GridMap::Memory memory_;
  std::array<Level, kLevels> levels_;
};

}  // namespace slam::scan_matching
