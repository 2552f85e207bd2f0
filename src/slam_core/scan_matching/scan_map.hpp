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

/// The beams of each resolution; the finest first.
using LevelModels = std::array<grid_map::BeamModel, kLevels>;
/// @param config of the finest, valid
LevelModels levelModels(const grid_map::GridMapConfig& config);
/// @param spacing of the ends to match in the finest [m]
ScanLevels pointsOf(const LaserScan& scan, const LevelModels& models, double spacing);
/// The memory that a scan may need where the map has nothing yet, over all levels [byte].
double mostBytesFor(const ScanLevels& scan);

/// A view of a map in several resolutions, which somebody else owns; the finest first.
struct MapView {
  struct Level {
    const grid_map::BeamModel& model;
    const grid_map::GridMap& map;
  };
  std::array<Level, kLevels> levels;

  const Level& finest() const { return levels.front(); }
  bool isEmpty() const { return finest().map.isEmpty(); }
};

/// A map in several resolutions.
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

  /// @param pose T_map_base
  /// @return the number of beams that end beyond the largest map
  std::size_t insert(const ScanLevels& scan, const Pose2& pose);

  bool isEmpty() const { return finest().map.isEmpty(); }
  MapView view() const {
    return {{{{levels_[0].model, levels_[0].map}, {levels_[1].model, levels_[1].map}}}};
  }
  const Level& finest() const { return levels_.front(); }
  Level& level(std::size_t i) { return levels_[i]; }
  std::size_t bytes() const { return memory_.bytes(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(levels_[0].map, levels_[1].map);
  }

 private:
  grid_map::GridMap::Memory memory_;
  std::array<Level, kLevels> levels_;
};

}  // namespace slam::scan_matching
