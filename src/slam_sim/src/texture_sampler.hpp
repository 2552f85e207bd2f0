// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_sim/texture.hpp"
#include "viewed_surface.hpp"

namespace slam::sim {

/// One level of a surface's texture, as its plane is seen from one place.
struct TextureView {
  const Texture::Level* level;
  LinearForm w;   ///< inverse depth
  LinearForm uw;  ///< stored coordinates, times w
  LinearForm vw;
};

/// A level of the surface's texture as seen.
TextureView viewTexture(const Surface& surface, const PlaneView& view, std::size_t level);

/// The level whose texels suit the pixels where this ray meets the surface.
/// @param ray_step change of a ray from pixel to pixel
std::size_t levelFor(const Surface& surface, const PlaneView& view, float ray_x, float ray_y,
                     const Eigen::Vector2d& ray_step);

/// Interpolated texels [0, 255] where n rays (x, y, 1) meet it. All of them must meet the surface.
/// @param n at most CameraRays::kTilePixels
void sampleTexture(const TextureView& view, const float* x, const float* y, int n, float* gray);

}  // namespace slam::sim
