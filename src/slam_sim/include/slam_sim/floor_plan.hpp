// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "slam_sim/world.hpp"

namespace slam::sim {

/// A vertical face from the floor up, seen from above.
struct Face {
  Eigen::Vector2d from, to;  ///< [m]
  double height = 0.0;       ///< [m]
  std::string name;          ///< of what it belongs to, for messages: "the wall from ... to ..."
  double brightness = 0.0;   ///< of what a laser gets back, 1 from a white wall
};

/// The faces of all walls and furniture: what a laser hits and a robot runs into.
class FloorPlan {
 public:
  explicit FloorPlan(const World& world);

  const std::vector<Face>& faces() const { return faces_; }
  bool hasReflectors() const { return has_reflectors_; }

  /// A ray ends at this distance [m] on this face; infinity and nullptr where it meets nothing.
  struct RayEnd {
    double distance;
    const Face* face;
  };
  /// The end of a ray along the unit vector `direction`, at the first face at least `z` high [m].
  RayEnd rayEnd(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double z) const;
  /// The distance to there [m].
  double rayCast(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double z) const {
    return rayEnd(origin, direction, z).distance;
  }

  /// The face next to a point, of those at least `z` high; nullptr in an empty plan.
  const Face* nearest(const Eigen::Vector2d& point, double z, double* distance) const;
  /// The first face that a straight way crosses or touches; nullptr where it is free.
  const Face* crossed(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double z) const;
  /// The piece of furniture that a point lies in, of those at least `z` high; nullptr where none.
  const Box* containing(const Eigen::Vector2d& point, double z) const;

 private:
  std::vector<Face> faces_;
  std::vector<Box> furniture_;
  bool has_reflectors_ = false;
};

/// The corners of a piece of furniture, counter-clockwise [m].
std::vector<Eigen::Vector2d> cornersOf(const Box& box);

double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to);

/// "(1.5, -2)"
std::string pointText(const Eigen::Vector2d& point);

}  // namespace slam::sim
