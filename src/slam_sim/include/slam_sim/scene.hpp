// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "slam_sim/light_map.hpp"
#include "slam_sim/texture.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {

/// A textured rectangle as the cameras see it.
struct Surface {
  Rectangle rectangle;
  bool two_sided = false;  ///< else it is seen from its normal's side only
  std::shared_ptr<const Texture> texture;
  double texels_per_metre = 1.0;
  Eigen::Vector2d texture_origin =
      Eigen::Vector2d::Zero();  ///< of u = v = 0 [texels], not negative
  double gain = 1.0;            ///< reflectance of a texel of 255
  LightMap light = LightMap::even(1.0);
};

/// What a world's surfaces look like. Read-only after construction, to be shared by all cameras.
class Scene {
 public:
  /// @throw std::invalid_argument a marker or a ceiling texture that there is not
  explicit Scene(const World& world);

  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  void addWalls(const World& world, const Lamps& lamps);
  void addDoors(const World& world, const Lamps& lamps);
  void addFurniture(const World& world, const Lamps& lamps);
  void addFloorAndCeiling(const World& world, const Lamps& lamps);
  void addMarkers(const World& world, const Lamps& lamps);

  std::vector<Surface> surfaces_;
};

}  // namespace slam::sim
