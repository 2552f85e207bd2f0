// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "slam_sim/camera_rays.hpp"
#include "slam_sim/scene.hpp"

namespace slam::sim {

/// A number for each ray (x, y, 1): its scalar product with these three.
struct LinearForm {
  float x, y, c;

  float at(float ray_x, float ray_y) const { return x * ray_x + y * ray_y + c; }
  float minOver(const RayBounds& rays) const;
  float maxOver(const RayBounds& rays) const;

  LinearForm operator+(const LinearForm& other) const;
  LinearForm operator-(const LinearForm& other) const;
  LinearForm operator*(float factor) const;
};

/// A plane seen from one place. All three are linear in the ray, so that a plane costs one division
/// a ray: the point that it meets is at depth 1 / w, at u = uw / w and v = vw / w of the rectangle.
struct PlaneView {
  LinearForm w;   ///< inverse depth [1/m]
  LinearForm uw;  ///< [1]
  LinearForm vw;  ///< [1]
};

/// A surface, seen from each of a pixel's samples (they differ in time).
struct ViewedSurface {
  const Surface* surface;
  float width, height;  ///< [m]
  std::vector<PlaneView> views;

  enum class Cover { kNone, kPart, kFull };

  /// Which part of those rays meets the surface; kNone and kFull are certain.
  Cover coverOf(const RayBounds& rays, std::size_t sample) const;
  /// Whether any sample may meet it.
  bool mayBeMetBy(const RayBounds& rays) const;
};

/// Surfaces that look toward the camera and may be met by those rays.
std::vector<ViewedSurface> viewedSurfaces(const std::vector<Surface>& surfaces,
                                          const std::vector<Eigen::Isometry3d>& T_world_cameras,
                                          const RayBounds& rays);

}  // namespace slam::sim
