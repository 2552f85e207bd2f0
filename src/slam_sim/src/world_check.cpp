// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "world_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "slam_sim/closed_spline.hpp"
#include "slam_sim/floor_plan.hpp"
#include "slam_sim/marker_family.hpp"
#include "slam_sim/world_file.hpp"

namespace slam::sim {
namespace {

constexpr double kGap = 0.001;      // between a marker and what it hangs on [m]
constexpr double kFreeView = 0.1;   // in front of a marker [m]
constexpr double kAlong = 0.01;     // sine of how much a door may be turned out of its wall
constexpr double kPathStep = 0.02;  // [m]

template <class... Parts>
std::string say(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// The marker seen from above.
struct Edge {
  Eigen::Vector2d left, right, centre, facing;
  double bottom, top;
};

Edge edgeOf(const Marker& marker) {
  const Eigen::Vector3d centre = marker.T_world_marker.translation();
  const Eigen::Matrix3d R = marker.T_world_marker.linear();
  const Eigen::Vector3d half = marker.size / 2.0 * R.col(0);
  const double up = marker.size / 2.0 * std::abs(R(2, 1));
  return {(centre - half).head<2>(), (centre + half).head<2>(), centre.head<2>(),
          R.col(2).head<2>(),        centre.z() - up,           centre.z() + up};
}

void checkMarker(const Marker& marker, const std::string& place, const FloorPlan& plan,
                 double ceiling, FaultCollector& faults) {
  const auto edge = edgeOf(marker);
  if (edge.bottom < 0.0 || edge.top > ceiling)
    faults.add(say(place, ": marker ", marker.id, " reaches from ", edge.bottom, " m to ", edge.top,
                   " m, beyond the floor or the ceiling at ", ceiling, " m"));
  double distance = 0.0;
  const auto* face = plan.nearest(edge.centre, edge.bottom, &distance);
  const auto* crossed = plan.crossed(edge.left, edge.right, edge.bottom);
  if (crossed == nullptr && face != nullptr && distance < kGap) crossed = face;
  if (const auto* box = plan.containing(edge.centre, edge.bottom))
    faults.add(say(place, ": marker ", marker.id, " at ", pointText(edge.centre),
                   " is inside the furniture at ", pointText(box->centre)));
  else if (crossed != nullptr)
    faults.add(say(place, ": marker ", marker.id, " at ", pointText(edge.centre), " is inside ",
                   crossed->name, "; it must hang at least ", kGap, " m in front of it"));
  else if (const double free = plan.rayCast(edge.centre, edge.facing, edge.top); free < kFreeView)
    faults.add(say(place, ": marker ", marker.id, " at ", pointText(edge.centre),
                   " looks at a wall or furniture ", free, " m away; does it face the other way?"));
}

/// Landmarks are told apart by their ids, offsets included.
void checkIds(const World& world, const WorldPlaces& places, FaultCollector& faults) {
  std::map<std::int64_t, std::string> seen;
  for (std::size_t i = 0; i < world.markers.size(); ++i) {
    const auto& marker = world.markers[i];
    const auto* family = findMarkerFamily(marker.family);
    if (family != nullptr && (marker.id < 0 || marker.id >= family->ids))
      faults.add(say(places.markers[i], ": the family ", family->name, " has no marker ", marker.id,
                     "; its ids are 0 to ", family->ids - 1));
    const auto [first, is_new] = seen.emplace(marker.landmark(), places.markers[i]);
    if (!is_new)
      faults.add(say(places.markers[i], ": there is a landmark ", marker.landmark(), " already, ",
                     first->second, "; give the marker another id, or its family an id_offset"));
  }
}

void checkHeights(const World& world, const WorldPlaces& places, FaultCollector& faults) {
  for (std::size_t i = 0; i < world.walls.size(); ++i)
    if (world.walls[i].height > world.ceiling.height)
      faults.add(say(places.walls[i], " is ", world.walls[i].height, " m high, the ceiling ",
                     world.ceiling.height, " m"));
  for (std::size_t i = 0; i < world.furniture.size(); ++i)
    if (world.furniture[i].size.z() > world.ceiling.height)
      faults.add(say(places.furniture[i], " is ", world.furniture[i].size.z(),
                     " m high, the ceiling ", world.ceiling.height, " m"));
}

/// A door hangs on a wall, which is at least as high.
void checkDoor(const Door& door, const std::string& place, const FloorPlan& plan, double ceiling,
               FaultCollector& faults) {
  constexpr double kNearWall = 0.05;  // [m]
  if (door.height > ceiling)
    faults.add(say(place, ": the door at ", pointText(door.position), " is ", door.height,
                   " m high, the ceiling ", ceiling, " m"));
  double distance = 0.0;
  const auto* face = plan.nearest(door.position, std::min(door.height, ceiling), &distance);
  if (face == nullptr || distance > kNearWall) {
    faults.add(say(place, ": the door at ", pointText(door.position),
                   " hangs on no wall; put it within ", kNearWall, " m of one"));
    return;
  }
  const Eigen::Vector2d normal(std::cos(door.facing), std::sin(door.facing));
  if (std::abs(normal.dot((face->to - face->from).normalized())) > kAlong)
    faults.add(say(place, ": the door at ", pointText(door.position), " does not lie along ",
                   face->name, "; its facing must be at right angles to it"));
}

bool hasRepeatedPoint(const std::vector<Eigen::Vector2d>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] == points[(i + 1) % points.size()]) return true;
  return false;
}

void checkPath(const World& world, const WorldPlaces& places, const FloorPlan& plan,
               FaultCollector& faults) {
  const auto& points = world.path.points;
  if (points.size() < 3 || hasRepeatedPoint(points)) {
    faults.add(places.path +
               (points.size() < 3
                    ? " has fewer than 3 points; the robot needs a way to drive"
                    : " has the same point twice in succession (it is closed by itself)"));
    return;
  }
  if (const auto* box = plan.containing(points.front(), 0.0)) {
    faults.add(places.path + " begins inside the furniture at " + pointText(box->centre));
    return;
  }
  const ClosedSpline curve(points);
  for (double s = 0.0; s < curve.length(); s += kPathStep)
    if (const auto* face = plan.crossed(curve.point(s), curve.point(s + kPathStep), 0.0)) {
      faults.add(
          say(places.path, " runs through ", face->name, " near ", pointText(curve.point(s))));
      return;
    }
}

}  // namespace

WorldPlaces placesOf(const World& world) {
  WorldPlaces places;
  const std::string prefix = "world " + world.name + ": ";
  places.world = "world " + world.name;
  places.path = prefix + "path";
  const auto number = [&](const std::string& what, std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i)
      names.push_back(prefix + what + "[" + std::to_string(i) + "]");
    return names;
  };
  places.walls = number("walls", world.walls.size());
  places.furniture = number("furniture", world.furniture.size());
  places.markers = number("markers", world.markers.size());
  places.doors = number("doors", world.doors.size());
  return places;
}

void checkFit(const World& world, const WorldPlaces& places, FaultCollector& faults) {
  if (world.walls.empty() && world.furniture.empty() && world.markers.empty()) {
    faults.add(places.world +
               " is an empty world: without walls, furniture and markers no sensor sees anything");
    return;
  }
  const FloorPlan plan(world);
  checkHeights(world, places, faults);
  checkIds(world, places, faults);
  for (std::size_t i = 0; i < world.markers.size(); ++i)
    checkMarker(world.markers[i], places.markers[i], plan, world.ceiling.height, faults);
  for (std::size_t i = 0; i < world.doors.size(); ++i)
    checkDoor(world.doors[i], places.doors[i], plan, world.ceiling.height, faults);
  checkPath(world, places, plan, faults);
}

void checkWorld(const World& world) {
  FaultCollector faults;
  checkFit(world, placesOf(world), faults);
  faults.raise();
}

}  // namespace slam::sim
