// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/world_file.hpp"

#include <cmath>
#include <sstream>

#include "slam_core/common/settings.hpp"
#include "slam_sim/marker_family.hpp"
#include "world_check.hpp"
#include "yaml_map.hpp"

namespace slam::sim {
namespace {

constexpr int kWorldVersion = 1;
const Range kGray = Range::closed(0.0, 1.0);
constexpr double kFarthest = 1000.0;  // [m]; a way that is longer by far would take hours to check
const Range kCoordinate = Range::closed(-kFarthest, kFarthest);
const Range kLength = {0.0, kFarthest, true, false};
constexpr double kBark = 0.3;       // gray
constexpr double kBrightest = 4.0;  // level of the light

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Reads one file; the parts' places are kept for the checks that come after.
class WorldReader {
 public:
  explicit WorldReader(FaultCollector& faults) : faults_(faults) {}

  World read(const std::string& path) {
    const auto document = loadConfigFile(path);
    YamlMap root(path, "", document.root, faults_);
    faults_.raise();
    readVersion(root);
    root.require("world", world_.name);
    root.read("floor_gray", world_.floor_gray, kGray);
    readFloor(root.map("floor"));
    readCeiling(root.map("ceiling"));
    readLight(root.map("light"));
    for (auto& wall : root.list("walls")) readWall(wall);
    for (auto& box : root.list("furniture")) readFurniture(box);
    for (auto& tree : root.list("trees")) readTree(tree);
    for (auto& doors : root.list("doors")) readDoors(doors);
    readMarkerDefaults(root.map("marker"));
    for (auto& marker : root.list("markers")) readMarker(marker);
    for (auto& row : root.list("marker_rows")) readRow(row);
    readPath(root.map("path"), path);
    root.finish();
    places_.world = path;
    return world_;
  }

  const WorldPlaces& places() const { return places_; }

 private:
  void readVersion(YamlMap& root) {
    int version = kWorldVersion;
    root.require("version", version);
    if (version != kWorldVersion)
      root.fault("has version " + std::to_string(version) + "; this program reads version " +
                 std::to_string(kWorldVersion));
  }

  void readFloor(YamlMap map) {
    map.read("texture", world_.floor_texture, floorTextures());
    map.finish();
  }

  void readLight(YamlMap map) {
    constexpr double kLongest = 1e6;  // [s]
    auto& course = world_.light.course;
    map.read("course", course, Range::closed(0.0, kLongest));
    map.finish();
    for (std::size_t i = 0; i < course.size(); ++i) {
      if (i > 0 && !(course[i].x() > course[i - 1].x())) {
        map.fault("course: the times must rise; after " + number(course[i - 1].x()) + " s comes " +
                  number(course[i].x()) + " s");
      }
      if (course[i].y() > kBrightest) {
        map.fault("course: the level " + number(course[i].y()) + " is not in [0, " +
                  number(kBrightest) + "]");
      }
    }
  }

  void readCeiling(YamlMap map) {
    map.read("height", world_.ceiling.height, kLength);
    map.read("texture", world_.ceiling.texture, ceilingTextures());
    map.read("scale", world_.ceiling.scale, kPositive);
    map.finish();
  }

  /// A line of one or more walls.
  void readWall(YamlMap& map) {
    std::vector<Eigen::Vector2d> points;
    bool closed = false;
    std::int64_t seed = 0;
    Wall wall;
    wall.height = world_.ceiling.height;
    map.require("points", points, kCoordinate);
    map.read("closed", closed);
    map.read("height", wall.height, kLength);
    map.read("gray", wall.gray, kGray);
    map.read("reflector", wall.is_reflector);
    map.read("texture", wall.texture, wallTextures());
    map.read("seed", seed, Range::closed(1.0, 1e6));
    map.finish();
    if (points.size() < 2) map.fault("needs at least 2 points");
    if (closed && !points.empty()) points.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
      wall.from = points[i - 1];
      wall.to = points[i];
      // Each wall has a look of its own, unless the file gives a seed: lines of one seed look
      // alike.
      wall.look = seed > 0 ? static_cast<std::uint64_t>(seed) << 32U | i : world_.walls.size();
      if (wall.from == wall.to) map.fault("has a part of length 0");
      world_.walls.push_back(wall);
      places_.walls.push_back(map.where());
    }
  }

  void readFurniture(YamlMap& map) {
    Box box;
    map.require("centre", box.centre, kCoordinate);
    map.require("size", box.size, kLength);
    map.read("yaw", box.yaw);
    map.read("gray", box.gray, kGray);
    map.read("texture", box.texture, furnitureTextures());
    map.finish();
    world_.furniture.push_back(box);
    places_.furniture.push_back(map.where());
  }

  /// A trunk or pole up to the ceiling, round but for a fiftieth of its radius.
  void readTree(YamlMap& map) {
    constexpr int kSides = 16;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0.0;
    Wall wall;
    wall.height = world_.ceiling.height;
    wall.gray = kBark;
    map.require("centre", centre, kCoordinate);
    map.require("radius", radius, kLength);
    map.read("gray", wall.gray, kGray);
    map.read("reflector", wall.is_reflector);
    map.finish();
    const auto corner = [&](int side) -> Eigen::Vector2d {
      const double angle = 2.0 * M_PI * (side % kSides) / kSides;
      return centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    };
    for (int side = 0; side < kSides; ++side) {
      wall.from = corner(side);
      wall.to = corner(side + 1);
      world_.walls.push_back(wall);
      places_.walls.push_back(map.where());
    }
  }

  /// Doors that face one way.
  void readDoors(YamlMap& map) {
    Door door;
    std::vector<Eigen::Vector2d> positions;
    map.require("positions", positions, kCoordinate);
    map.require("facing", door.facing);
    map.read("width", door.width, kLength);
    map.read("height", door.height, kLength);
    map.finish();
    for (const auto& position : positions) {
      door.position = position;
      world_.doors.push_back(door);
      places_.doors.push_back(map.where());
    }
  }

  void readMarkerDefaults(YamlMap map) {
    default_.family = "36h11";
    map.read("family", default_.family, markerFamilyNames());
    map.read("size", default_.size, kLength);
    map.finish();
  }

  void readMarker(YamlMap& map) {
    Marker marker = default_;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double facing = 0.0;
    map.require("id", marker.id);
    map.read("family", marker.family, markerFamilyNames());
    map.read("id_offset", marker.id_offset, Range::atLeast(0.0));
    map.read("size", marker.size, kLength);
    map.require("position", position, kCoordinate);
    map.require("facing", facing);
    map.finish();
    add(marker, position, facing, map.where());
  }

  /// Markers of successive ids at equal distances on a straight line.
  void readRow(YamlMap& map) {
    Marker marker = default_;
    std::int64_t first_id = 0;
    int count = 1;
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
    double facing = 0.0;
    map.require("first_id", first_id, Range::atLeast(0.0));
    map.require("count", count, Range::closed(2.0, 10000.0));
    map.read("family", marker.family, markerFamilyNames());
    map.read("id_offset", marker.id_offset, Range::atLeast(0.0));
    map.read("size", marker.size, kLength);
    map.require("from", from, kCoordinate);
    map.require("to", to, kCoordinate);
    map.require("facing", facing);
    map.finish();
    for (int i = 0; i < count && count <= 10000; ++i) {
      marker.id = first_id + i;
      const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
      add(marker, from + share * (to - from), facing, map.where());
    }
  }

  void add(Marker& marker, const Eigen::Vector3d& position, double facing,
           const std::string& place) {
    marker.T_world_marker = uprightMarker(position, facing);
    world_.markers.push_back(marker);
    places_.markers.push_back(place);
  }

  void readPath(YamlMap map, const std::string& file) {
    map.read("points", world_.path.points, kCoordinate);
    map.read("speed", world_.path.speed, kPositive);
    map.read("laps", world_.path.laps, Range::closed(1.0, 1000.0));
    map.finish();
    places_.path = world_.path.points.empty() ? file + ": path" : map.where();
  }

  FaultCollector& faults_;
  World world_;
  Marker default_;
  WorldPlaces places_;
};

}  // namespace

World readWorldFile(const std::string& path) {
  FaultCollector faults;
  WorldReader reader(faults);
  const World world = reader.read(path);
  faults.raise();
  checkFit(world, reader.places(), faults);
  faults.raise();
  return world;
}

}  // namespace slam::sim
