// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <string>

#include "slam_sim/marker_texture.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

constexpr int kEdge = 1024;           // of the seamless textures [texels]
constexpr int kCeilingEdge = 2048;    // [texels]
constexpr int kTexelsPerCell = 32;    // of a marker
constexpr double kWallPeriod = 2.0;   // [m]
constexpr double kFloorPeriod = 1.5;  // [m]
constexpr double kWoodPeriod = 1.0;   // [m]
constexpr double kPaper = 0.9;        // reflectance of white paper
constexpr double kInk = 0.08;         // and of what is printed black on it
constexpr double kSkirtingHeight = 0.08, kSkirtingDepth = 0.006;  // [m]
constexpr double kOutdoors = 2.0;    // floor and ceiling beyond the outermost wall [m]
constexpr std::uint64_t kLook = 20;  // the textures' seed: a world always looks the same

using TexturePtr = std::shared_ptr<const Texture>;

/// The seamless texture of that name; painted once, for all worlds.
TexturePtr seamless(const std::string& name, const std::function<cv::Mat()>& paint) {
  static std::map<std::string, TexturePtr> painted;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  TexturePtr& texture = painted[name];
  if (!texture) texture = std::make_shared<const Texture>(paint(), Texture::Wrap::kRepeat);
  return texture;
}

Eigen::Vector3d onFloor(const Eigen::Vector2d& xy, double z = 0.0) { return {xy.x(), xy.y(), z}; }

/// A surface with a seamless texture, of that mean reflectance.
Surface textured(const Rectangle& rectangle, const TexturePtr& texture, double period, double gray,
                 const LightMap& light) {
  Surface surface;
  surface.rectangle = rectangle;
  surface.texture = texture;
  const auto edge = static_cast<double>(texture->levels().front().mask_u + 1);
  surface.texels_per_metre = edge / period;
  surface.gain = gray * 255.0 / texture->mean();
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
  surfaces_.push_back(textured(floor, seamless("floor", [] { return floorTexture(kEdge, kLook); }),
                               kFloorPeriod, world.floor_gray, LightMap(floor, lamps)));

  const auto tiles = seamless("ceiling " + world.ceiling.texture, [&] {
    return ceilingTexture(world.ceiling.texture, kCeilingEdge, kLook + 1);
  });
  const double period = kCeilingTiles * world.ceiling.scale;
  Surface above = textured(ceiling, tiles, period, 1.0, LightMap::even(1.0));
  above.gain = 1.0;  // lamps shine by themselves
  // The texture's grid starts in the world's origin, as that of the lamps.
  for (int axis = 0; axis < 2; ++axis) {
    const double periods = extent.min()[axis] / period;
    above.texture_origin[axis] = (periods - std::floor(periods)) * kCeilingEdge;
  }
  surfaces_.push_back(above);
}

void Scene::addWalls(const World& world, const Lamps& lamps) {
  const auto plaster = seamless("plaster", [] { return plasterTexture(kEdge, kLook + 2); });
  const auto wallpaper = seamless("wallpaper", [] { return wallpaperTexture(kEdge, kLook + 4); });
  const auto wood = seamless("wood", [] { return woodTexture(kEdge, kLook + 6); });
  double start = 0.0;  // no two walls show the same part
  for (std::size_t i = 0; i < world.walls.size(); ++i) {
    const Wall& wall = world.walls[i];
    const Rectangle face = upright(wall.from, wall.to, wall.height);
    Surface surface = textured(face, i % 4 == 2 ? wallpaper : plaster, kWallPeriod, wall.gray,
                               LightMap(face, lamps));
    surface.two_sided = true;
    surface.texture_origin.x() = std::fmod(start, kEdge);
    start += 317.0 + face.width * surface.texels_per_metre;
    surfaces_.push_back(surface);

    const Eigen::Vector2d along = (wall.to - wall.from).normalized();
    const Eigen::Vector2d right = kSkirtingDepth * Eigen::Vector2d(along.y(), -along.x());
    for (const Rectangle& board : {upright(wall.from + right, wall.to + right, kSkirtingHeight),
                                   upright(wall.to - right, wall.from - right, kSkirtingHeight)}) {
      surfaces_.push_back(textured(board, wood, kWoodPeriod, 0.3, LightMap(board, lamps)));
    }
  }
}

void Scene::addFurniture(const World& world, const Lamps& lamps) {
  const auto wood = seamless("wood", [] { return woodTexture(kEdge, kLook + 6); });
  for (const Box& box : world.furniture) {
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
      surfaces_.push_back(textured(face, wood, kWoodPeriod, box.gray, LightMap(face, lamps)));
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
