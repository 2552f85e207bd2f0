// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_graph.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/loaded_grid.hpp"

// Frames: odom is that of the scan tracker, in which submaps are drawn; it never jumps. The graph
// says where their origins lie in the map.

namespace slam::graph_slam {

using scan_matching::ScanLevels;

ScanGraph::ScanGraph(PathGraph& path, const GraphConfig& config,
                     const grid_map::GridMapConfig& grid,
                     const scan_matching::MatcherConfig& matcher)
    : path_(path),
      config_(config),
      grid_config_(grid),
      drift_(config.driftPerMetre()),
      models_(scan_matching::levelModels(grid)),
      spacing_(matcher.spacing),
      submaps_(grid, config.submap_way),
      search_(matcher, config.submap_way, drift_),
      loops_(path.graph(), graph::RobustLoops::Noise::kAsTold),
      renderer_(grid),
      tracker_(matcher),
      trigger_(config.insert_distance, config.insert_angle),
      doubt_(config.lost_share, matcher.false_alarm_hours, config.mapIsFixed()) {
  tracker_.restart({});
}

void ScanGraph::restart(const PoseEstimate& robot) {
  const Pose2 T_odom_map = mapFromOdom().inverse();
  tracker_.restart({T_odom_map * robot.pose, coordinateCovariance(T_odom_map, robot.covariance)});
  trigger_.restart();
  doubt_.forget();
  watch_.restart();
  told_.restart();
}

/// The grid hangs on a variable of its own, that lies where the grid says.
Status ScanGraph::load(const OccupancyGrid& grid) {
  constexpr double kExact = 1e3;
  auto [loaded, status] = drawn(grid, grid_config_);
  if (status.level == Status::Level::kError) return status;
  const auto origin = path_.graph().add(Pose2());
  path_.graph().add(
      std::make_unique<graph::PosePrior>(origin, Pose2(), kExact * Eigen::Matrix3d::Identity()));
  path_.optimize(1);
  submaps_.startWith({std::move(loaded), origin, placesIn(grid)});
  renderer_.startWith(grid);
  return status;
}

void ScanGraph::predict(const Motion& motion) { told_.predict(motion); }

Status ScanGraph::take(const LaserScan& scan, Counters& counters) {
  inserted_.reset();
  const auto levels = scan_matching::pointsOf(scan, models_, spacing_);
  loop_watch_.begin();
  told_.locate(tracker_.robot());
  const auto found = match(levels, scan.stamp, counters);
  correctPath(found.is_determined);
  if (!doubt_.admits()) {
    counters.add("contradicting");
    return Status::ok();
  }
  const bool is_due = submaps_.current().isEmpty() || trigger_.isDue(tracker_.robot().pose);
  if (config_.mapIsFixed() || !is_due || levels[0].beams.empty()) return Status::ok();
  return insert(scan, levels, found, counters);
}

Pose2 ScanGraph::mapFromOdom() const {
  const auto& submap = submaps_.current();
  if (submap.origin() < 0) return {};
  return path_.graph().pose(submap.origin()) * submap.odomOrigin().inverse();
}

scan_matching::Match ScanGraph::match(const ScanLevels& scan, Stamp stamp, Counters& counters) {
  const auto motion = told_.takeMotion();
  const auto map = submaps_.currentView();
  const auto found = tracker_.track(map, scan, stamp, motion);
  watch_.note(scan, map.isEmpty(), found, motion.has_value(), counters);
  doubt_.judge(found, stamp);
  return found;
}

/// Where the path has no node yet, the submap says where the robot is.
void ScanGraph::correctPath(bool is_determined) {
  const auto& now = tracker_.robot();
  if (told_.follow(now, is_determined) || submaps_.current().isEmpty()) return;
  const Pose2 T_map_odom = mapFromOdom();
  path_.relocate({T_map_odom * now.pose, coordinateCovariance(T_map_odom, now.covariance)});
}

/// A scan that fits nothing shows what the map does not have yet: the robot goes on from there. A
/// scan that is drawn defines the map around it, so that relative to that map the robot is exact
/// from there: its error is counted once, in the motion to this node, and not again in the next.
Status ScanGraph::insert(const LaserScan& scan, const ScanLevels& points,
                         const scan_matching::Match& found, Counters& counters) {
  if (!grid_map::isWithinMemory(mostBytes() + scan_matching::mostBytesFor(points), grid_config_)) {
    counters.add("scans_without_memory");
    return Status::warning(
        "the graph's scans would need more than grid_map.largest_memory and the map is kept as it "
        "is: raise it or grid_map.resolution");
  }
  const auto robot = tracker_.robot();
  const Eigen::Matrix3d of_scan = robot.covariance * found.information * robot.covariance;
  const auto node = told_.insert(robot, symmetric(of_scan), found.is_determined);
  tracker_.anchor();
  const auto shared = inserted_ = std::make_shared<const LaserScan>(scan);
  submaps_.insert(shared, points, node, robot.pose);
  trigger_.note(robot.pose);
  path_.optimize(config_.iterations);
  renderer_.add(node, path_.robot().pose, shared);
  closeLoops(points, node, counters);
  renderer_.follow(path_.graph());
  reduction_.reduce();
  return Status::ok();
}

void ScanGraph::closeLoops(const ScanLevels& scan, graph::Key node, Counters& counters) {
  const auto closures = search_.find(scan, path_, submaps_);
  for (const auto& closure : closures) {
    const auto W = graph::weightOfCovariance(closure.covariance);
    const bool is_believed =
        loops_.add(std::make_shared<graph::Between>(closure.node, node, closure.node_robot, W));
    counters.add(is_believed ? "loops" : "loops_that_wait");
    if (closure.was_searched) counters.add("searched_loops");
  }
  if (closures.empty()) return;
  constexpr int kSettled = 10;
  const Pose2 before = path_.graph().pose(node);
  loops_.judge([this] { path_.optimize(kSettled); });
  loop_watch_.note(loops_.changes(), before, path_.graph().pose(node));
}

Status ScanGraph::status() const {
  if (const auto told = doubt_.status(); !told.isOk()) return told;
  return watch_.status();
}

std::optional<OccupancyGrid> ScanGraph::grid() const { return renderer_.grid(); }

}  // namespace slam::graph_slam
