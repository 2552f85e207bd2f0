// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

#include "slam_sim/camera_rays.hpp"
#include "viewed_surface.hpp"

namespace slam::sim {

/// Renders the tiles of one image, one after another; keeps its scratch memory between them.
class TileRenderer {
 public:
  /// @param ray_step change of a ray from pixel to pixel. `rays` outlives this.
  TileRenderer(const CameraRays& rays, const Eigen::Vector2d& ray_step)
      : rays_(rays), ray_step_(ray_step) {}

  /// Mean light from each pixel, 1 a white surface in full light. Of several surfaces at one
  /// depth the first counts.
  const TileValues& render(int tile, const std::vector<const ViewedSurface*>& candidates);

 private:
  /// A surface in this tile.
  struct Entry {
    const ViewedSurface* viewed;
    bool prepared = false;
    std::size_t level = 0;
    TileValues light;
  };

  void prepare(Entry& entry) const;
  void renderSample(std::size_t sample);
  /// Entries that may be seen in this sample, those behind one that fills the tile left out.
  /// Whether there is just one, which fills the tile.
  bool selectSeen(std::size_t sample);
  void findNearest(std::size_t sample);
  void addAll(Entry& entry, std::size_t sample);
  void addWhereNearest(int seen_index, std::size_t sample);

  const CameraRays& rays_;
  Eigen::Vector2d ray_step_;
  int tile_ = 0;
  std::vector<Entry> entries_;
  std::vector<Entry*> seen_;
  TileValues sum_, depth_, gray_, x_, y_;
  std::array<std::int32_t, CameraRays::kTilePixels> nearest_, pixels_;
};

}  // namespace slam::sim
