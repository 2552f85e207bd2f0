// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/grid_map_config.hpp"
#include "slam_core/grid_map/scan_points.hpp"
#include "slam_core/grid_map/tile_set.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam::graph_slam {

/// Scans drawn one over the other. Where one of them has moved or gone, only the tiles are drawn
/// anew that it wrote to or is to write to: erase() each such scan where it was and where it is to
/// be, clearErased(), then redraw() all that stay, in their order. The result is that of drawing
/// all of them anew.
class GridDrawing {
 public:
  /// @param base scans are drawn over it
  GridDrawing(const grid_map::GridMapConfig& config, const grid_map::BeamModel& model,
              const std::optional<OccupancyGrid>& base);
  GridDrawing(const GridDrawing&) = delete;  // the maps point into the memory
  GridDrawing& operator=(const GridDrawing&) = delete;

  /// @param pose T_map_base, here and below
  void draw(const grid_map::ScanPoints& scan, const Pose2& pose);
  void erase(const grid_map::ScanPoints& scan, const Pose2& pose);
  /// @return false where all must be drawn anew: what a cell holds may depend on scans that do not
  /// touch it, since beams were read with the map's help, or the map may end before it holds all
  bool clearErased();
  /// Whether redraw() may matter of a scan that writes to nothing further away than `reach` [m].
  bool mayBeTouched(const Pose2& pose, double reach) const;
  void redraw(const grid_map::ScanPoints& scan, const Pose2& pose);
  OccupancyGrid grid() const;

 private:
  bool fitsWith(const std::vector<grid_map::CellIndex>& tiles) const;

  grid_map::BeamModel model_;
  std::size_t most_tiles_;
  grid_map::GridMap::Memory memory_;
  grid_map::GridMap base_, map_;
  bool depends_on_map_ = false;  ///< how a beam was read
  std::vector<grid_map::CellIndex> erased_;
  std::optional<grid_map::TileSet> cleared_;
};

}  // namespace slam::graph_slam
