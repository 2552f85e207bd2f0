// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "slam_core/camera/camera_calibration.hpp"

namespace slam::sim {

/// Bounds of rays (x, y, 1).
struct RayBounds {
  float x_min, x_max, y_min, y_max;

  void extend(const RayBounds& other);
};

/// Where the samples of an image look: rays (x, y, 1) in the optical frame, lens distortion taken
/// out, in the order in which an image is rendered, tile by tile.
///
/// Each pixel has `samples` rays, stratified in both directions and in time (sample i looks at
/// (i + 1/2) / samples of the exposure; a lattice of hyper-rooks, shifted at random from pixel to
/// pixel on the torus: Cranley and Patterson, SIAM J. Numer. Anal. 13(6), 1976). Pixel centres have
/// integer coordinates, as in CameraInfo and OpenCV.
class CameraRays {
 public:
  static constexpr int kTileEdge = 16;                       ///< [px]
  static constexpr int kTilePixels = kTileEdge * kTileEdge;  ///< row by row

  CameraRays(const CameraCalibration& calibration, int samples);

  int samples() const { return samples_; }
  int columns() const { return columns_; }  ///< [tiles]
  int rows() const { return rows_; }        ///< [tiles]

  /// kTilePixels values each.
  const float* x(int tile, int sample) const { return &x_[index(tile, sample)]; }
  const float* y(int tile, int sample) const { return &y_[index(tile, sample)]; }
  const RayBounds& bounds(int tile) const { return bounds_[static_cast<std::size_t>(tile)]; }

 private:
  std::size_t index(int tile, int sample) const {
    return static_cast<std::size_t>(tile * samples_ + sample) * kTilePixels;
  }

  int samples_, columns_, rows_;
  std::vector<float> x_, y_;
  std::vector<RayBounds> bounds_;
};

/// A value for each pixel of a tile.
using TileValues = std::array<float, CameraRays::kTilePixels>;

}  // namespace slam::sim
