// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/point_map/point_set.hpp"

namespace slam::point_map {

/// A piece of a surface as the map's points tell it.
struct SurfaceLine {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();    ///< on it [m]
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< of unit length
  bool is_line = false;                               ///< else the points lie as a heap
};

/// Through the map's points within `radius` [m] of a place, each weighted by its end points but by
/// no more than `cap` of them.
SurfaceLine surfaceLine(const Eigen::Vector2d& place, double radius, std::uint32_t cap,
                        const PointSet& map);

}  // namespace slam::point_map
