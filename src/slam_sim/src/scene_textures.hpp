// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "slam_sim/texture.hpp"

namespace slam::sim {

using TexturePtr = std::shared_ptr<const Texture>;

constexpr int kSeamlessEdge = 1024;  ///< [texels]
constexpr int kCeilingEdge = 2048;   ///< [texels]

/// A texture that repeats, and after how many metres. Each is painted once, for all worlds.
struct Seamless {
  TexturePtr texture;
  double period = 1.0;  ///< [m]
};

Seamless wallCover(const std::string& name);       ///< of wallTextures(), but the painted ones
Seamless floorCover(const std::string& name);      ///< one of floorTextures()
Seamless furnitureCover(const std::string& name);  ///< one of furnitureTextures()
TexturePtr ceilingCover(const std::string& name);  ///< one of ceilingTextures()
TexturePtr doorCover(double width, double height);

/// Whether a wall of that texture has a picture of its own, from end to end.
bool isPainted(const std::string& wall_texture);
TexturePtr paintedCover(const std::string& name, double width, double height, std::uint64_t look);

}  // namespace slam::sim
