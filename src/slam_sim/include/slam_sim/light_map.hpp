// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace slam::sim {

/// A rectangle in the world: origin + u * eu + v * ev, u in [0, width], v in [0, height] [m].
struct Rectangle {
  Eigen::Vector3d origin, eu, ev;  ///< eu, ev: unit vectors at right angles
  double width, height;            ///< [m]

  /// Out of the face: to the viewer who sees u run to the right and v run down.
  Eigen::Vector3d normal() const { return ev.cross(eu); }
  Eigen::Vector3d at(double u, double v) const { return origin + u * eu + v * ev; }
};

/// The ceiling's lamps: an endless square grid of panels that shine down.
struct Lamps {
  double height = 2.5;   ///< [m]
  double spacing = 2.4;  ///< [m]
  double first = 0.9;    ///< x and y of one of them [m]
};

/// Light that falls on a point of a surface, about 1 on the floor under a lamp: an even part, and
/// from each lamp as the cosines at both ends over the squared distance. Shadows are left out.
double irradiance(const Lamps& lamps, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/// The irradiance of a rectangle, both faces alike, on a grid.
class LightMap {
 public:
  static LightMap even(double value);
  LightMap(const Rectangle& rectangle, const Lamps& lamps);

  /// Interpolated; outside of the rectangle that of its edge.
  float at(double u, double v) const;  ///< [m]

 private:
  LightMap() = default;

  double per_metre_u_ = 0.0, per_metre_v_ = 0.0;
  int columns_ = 1, rows_ = 1;  ///< cells; there is one value more in each direction
  std::vector<float> values_;
};

}  // namespace slam::sim
