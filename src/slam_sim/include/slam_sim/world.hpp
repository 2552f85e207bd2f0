// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace slam::sim {

/// A vertical rectangle that stands on the floor; both its sides are seen.
struct Wall {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();  ///< [m]
  double height = 2.5;                                                           ///< [m]
  double gray = 0.8;              ///< part of the light that it throws back, 0 black to 1 white
  bool is_reflector = false;      ///< it throws a laser's light back to where it came from
  std::string texture = "paint";  ///< one of wallTextures(); paint: plaster, each fourth wallpaper
  std::uint64_t look = 0;         ///< walls of one look, texture and size are painted alike
};

/// A piece of furniture, a box that stands on the floor.
struct Box {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();       ///< [m]
  double yaw = 0.0;                                       ///< [rad]
  Eigen::Vector3d size = Eigen::Vector3d::Constant(1.0);  ///< along its own x, y and up [m]
  double gray = 0.5;
  std::string texture = "wood";  ///< one of furnitureTextures()
};

/// A closed door in the plane of a wall. Every door looks like every other.
struct Door {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the middle of its sill, on a wall [m]
  double facing = 0.0;                                 ///< heading of its normal [rad]
  double width = 0.9, height = 2.0;                    ///< [m]
};

/// A printed marker. Its frame: x to the right and y up as one looks at it, z out of the face
/// toward the viewer, the origin in the middle.
struct Marker {
  std::string family;  ///< one of markerFamilies()
  std::int64_t id = 0;
  double size = 0.16;  ///< edge of the square whose corners a detector returns [m]
  Eigen::Isometry3d T_world_marker = Eigen::Isometry3d::Identity();
  std::int64_t id_offset = 0;  ///< what a product with several families adds to its id

  /// The landmark's id in the ground truth.
  std::int64_t landmark() const { return id_offset + id; }
};

/// One plane above everything.
struct Ceiling {
  double height = 2.5;            ///< [m]
  std::string texture = "tiles";  ///< one of ceilingTextures()
  double scale = 0.6;             ///< edge of a tile, or size of the largest blots [m]
};

/// It says how bright the light is while the robot drives.
struct Light {
  /// Seconds since the start, rising, and the level then (1: full light); linear in between,
  /// constant before and after. Empty: always 1.
  std::vector<Eigen::Vector2d> course;

  double levelAt(double time) const;  ///< `time` since the start [s]
};

/// What the robot drives: a smooth closed curve through the way-points, `laps` times.
struct DrivePath {
  std::vector<Eigen::Vector2d> points;  ///< [m], the last is not the first one again
  double speed = 0.3;                   ///< where no curve and no end slows it down [m/s]
  int laps = 2;
};

/// What the simulation takes place in. Frame `world`: x and y in the floor, z up [m].
struct World {
  std::string name;
  std::vector<Wall> walls;
  std::vector<Box> furniture;
  std::vector<Marker> markers;
  std::vector<Door> doors;
  Ceiling ceiling;
  double floor_gray = 0.45;
  std::string floor_texture = "linoleum";  ///< one of floorTextures()
  Light light;
  DrivePath path;
};

/// The textures a ceiling can have: "tiles", "plaster" (blots of all sizes), "plain".
const std::vector<std::string>& ceilingTextures();
const std::vector<std::string>& wallTextures();
const std::vector<std::string>& floorTextures();
const std::vector<std::string>& furnitureTextures();

/// A marker on a vertical surface: `facing` is the heading of its normal [rad].
Eigen::Isometry3d uprightMarker(const Eigen::Vector3d& position, double facing);

}  // namespace slam::sim
