// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "painted_wall.hpp"
#include "scene_textures.hpp"
#include "slam_sim/marker_texture.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

constexpr int kTexelsPerCell = 32;  // of a marker
constexpr double kPaper = 0.9;      // reflectance of white paper
constexpr double kInk = 0.08;       // and of what is printed black on it
constexpr double kSkirtingHeight = 0.08, kSkirtingDepth = 0.006;  // [m]
constexpr double kDoorDepth = 0.008;                              // a door leaf before its wall [m]
constexpr double kDoorGray = 0.6;
constexpr double kOutdoors = 2.0;  // floor and ceiling beyond the outermost wall [m]

Eigen::Vector3d onFloor(const Eigen::Vector2d& xy, double z = 0.0) { return {xy.x(), xy.y(), z}; }

/// A surface with a seamless texture, of that mean reflectance.
Surface textured(const Rectangle& rectangle, const Seamless& cover, double gray,
                 const LightMap& light) {
  Surface surface;
  surface.rectangle = rectangle;
  surface.texture = cover.texture;
  const auto edge = static_cast<double>(cover.texture->levels().front().mask_u + 1);
  surface.texels_per_metre = edge / cover.period;
  surface.gain = gray * 255.0 / cover.texture->mean();
  surface.light = light;
  return surface;
}

/// A wall with a picture of its own.
Surface painted(const Wall& wall, const Rectangle& face, const LightMap& light) {
  Surface surface;
  surface.rectangle = face;
  surface.texture = paintedCover(wall.texture, face.width, face.height, wall.look);
  surface.texels_per_metre = paintedTexelsPerMetre(face.width, face.height);
  surface.gain = wall.gray * 255.0 / surface.texture->mean();
  surface.light = light;
  return surface;
}

/// What stands upright on the line from `from` to `to`, facing to the right of that direction.
Rectangle upright(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height) {
  const Eigen::Vector2d along = to - from;
  return {onFloor(from, height), onFloor(along.normalized()), -Eigen::Vector3d::UnitZ(),
          along.norm(), height};
}

Lamps lampsOf(const Ceiling& ceiling) {
  Lamps lamps;
  lamps.height = ceiling.height;
  lamps.spacing = std::clamp(kLampSpacing * ceiling.scale, 1.6, 4.0);
  lamps.first = (kFirstLamp + 0.5) * ceiling.scale;
  return lamps;
}

Eigen::AlignedBox2d extentOf(const World& world) {
  Eigen::AlignedBox2d box;
  for (const Wall& wall : world.walls) box.extend(wall.from).extend(wall.to);
  for (const Box& piece : world.furniture) box.extend(piece.centre);
  for (const Marker& marker : world.markers) {
    box.extend(Eigen::Vector2d(marker.T_world_marker.translation().head<2>()));
  }
  for (const auto& point : world.path.points) box.extend(point);
  if (box.isEmpty()) box.extend(Eigen::Vector2d(0.0, 0.0));
  const Eigen::Vector2d beyond = Eigen::Vector2d::Constant(kOutdoors);
  return {box.min() - beyond, box.max() + beyond};
}

}  // namespace

Scene::Scene(const World& world) {
  const Lamps lamps = lampsOf(world.ceiling);
  addFloorAndCeiling(world, lamps);
  addWalls(world, lamps);
  addDoors(world, lamps);
  addFurniture(world, lamps);
  addMarkers(world, lamps);
}

void Scene::addFloorAndCeiling(const World& world, const Lamps& lamps) {
  const auto extent = extentOf(world);
  const Eigen::Vector2d size = extent.sizes();
  const double height = world.ceiling.height;
  // Seen from above, x to the right and y up; seen from below, x to the right and y down.
  const Rectangle floor{{extent.min().x(), extent.max().y(), 0.0},
                        Eigen::Vector3d::UnitX(),
                        -Eigen::Vector3d::UnitY(),
                        size.x(),
                        size.y()};
  const Rectangle ceiling{onFloor(extent.min(), height), Eigen::Vector3d::UnitX(),
                          Eigen::Vector3d::UnitY(), size.x(), size.y()};
  surfaces_.push_back(
      textured(floor, floorCover(world.floor_texture), world.floor_gray, LightMap(floor, lamps)));

  const double period = kCeilingTiles * world.ceiling.scale;
  Surface above =
      textured(ceiling, {ceilingCover(world.ceiling.texture), period}, 1.0, LightMap::even(1.0));
  above.gain = 1.0;  // lamps shine by themselves
  // The texture's grid starts in the world's origin, as that of the lamps.
  for (int axis = 0; axis < 2; ++axis) {
    const double periods = extent.min()[axis] / period;
    above.texture_origin[axis] = (periods - std::floor(periods)) * kCeilingEdge;
  }
  surfaces_.push_back(above);
}

void Scene::addWalls(const World& world, const Lamps& lamps) {
  const auto wood = furnitureCover("wood");
  double start = 0.0;  // no two walls show the same part
  for (std::size_t i = 0; i < world.walls.size(); ++i) {
    const Wall& wall = world.walls[i];
    const Rectangle face = upright(wall.from, wall.to, wall.height);
    const auto paint = i % 4 == 2 ? "wallpaper" : "plaster";
    Surface surface =
        isPainted(wall.texture)
            ? painted(wall, face, LightMap(face, lamps))
            : textured(face, wallCover(wall.texture == "paint" ? paint : wall.texture), wall.gray,
                       LightMap(face, lamps));
    surface.two_sided = true;
    if (!isPainted(wall.texture)) {
      surface.texture_origin.x() = std::fmod(start, kSeamlessEdge);
      start += 317.0 + face.width * surface.texels_per_metre;
    }
    surfaces_.push_back(surface);

    const Eigen::Vector2d along = (wall.to - wall.from).normalized();
    const Eigen::Vector2d right = kSkirtingDepth * Eigen::Vector2d(along.y(), -along.x());
    for (const Rectangle& board : {upright(wall.from + right, wall.to + right, kSkirtingHeight),
                                   upright(wall.to - right, wall.from - right, kSkirtingHeight)}) {
      surfaces_.push_back(textured(board, wood, 0.3, LightMap(board, lamps)));
    }
  }
}

void Scene::addDoors(const World& world, const Lamps& lamps) {
  std::map<std::pair<double, double>, TexturePtr> leaves;
  for (const Door& door : world.doors) {
    const Eigen::Vector2d out(std::cos(door.facing), std::sin(door.facing));
    const Eigen::Vector2d half = door.width / 2.0 * Eigen::Vector2d(out.y(), -out.x());
    const Eigen::Vector2d middle = door.position + kDoorDepth * out;
    TexturePtr& leaf = leaves[{door.width, door.height}];
    if (!leaf) leaf = doorCover(door.width, door.height);
    Surface surface;
    // Seen from before it, its left is where the normal's left is.
    surface.rectangle = upright(middle + half, middle - half, door.height);
    surface.texture = leaf;
    surface.texels_per_metre = paintedTexelsPerMetre(door.width, door.height);
    surface.gain = kDoorGray * 255.0 / leaf->mean();
    surface.light = LightMap(surface.rectangle, lamps);
    surfaces_.push_back(surface);
  }
}

void Scene::addFurniture(const World& world, const Lamps& lamps) {
  for (const Box& box : world.furniture) {
    const auto cover = furnitureCover(box.texture);
    const Eigen::Rotation2Dd turn(box.yaw);
    const auto corner = [&](double x, double y) -> Eigen::Vector2d {
      return box.centre + turn * Eigen::Vector2d(x * box.size.x() / 2.0, y * box.size.y() / 2.0);
    };
    const Eigen::Vector2d corners[] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    std::vector<Rectangle> faces;
    for (int i = 0; i < 4; ++i) {
      faces.push_back(upright(corners[i], corners[(i + 1) % 4], box.size.z()));
    }
    faces.push_back({onFloor(corners[3], box.size.z()), onFloor(turn * Eigen::Vector2d::UnitX()),
                     onFloor(turn * -Eigen::Vector2d::UnitY()), box.size.x(), box.size.y()});
    for (const Rectangle& face : faces) {
      surfaces_.push_back(textured(face, cover, box.gray, LightMap(face, lamps)));
    }
  }
}

void Scene::addMarkers(const World& world, const Lamps& lamps) {
  for (const Marker& marker : world.markers) {
    const MarkerPattern pattern = markerPattern(marker.family, marker.id);
    const double cell = marker.size / pattern.border_cells;
    cv::Mat print;
    cv::resize(pattern.cells, print, cv::Size(), kTexelsPerCell, kTexelsPerCell, cv::INTER_NEAREST);
    print = cv::max(print, 255.0 * kInk / kPaper);
    const Eigen::Matrix3d R = marker.T_world_marker.linear();
    const double edge = cell * pattern.cells.cols;
    // The pattern's square is in the middle of its paper.
    Surface surface;
    surface.rectangle.eu = R.col(0);
    surface.rectangle.ev = -R.col(1);
    surface.rectangle.origin = marker.T_world_marker.translation() -
                               edge / 2.0 * (surface.rectangle.eu + surface.rectangle.ev);
    surface.rectangle.width = surface.rectangle.height = edge;
    surface.texture = std::make_shared<const Texture>(print, Texture::Wrap::kClamp);
    surface.texels_per_metre = kTexelsPerCell / cell;
    surface.gain = kPaper;
    surface.light = LightMap(surface.rectangle, lamps);
    surfaces_.push_back(surface);
  }
}

}  // namespace slam::sim
