// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "exit_code.hpp"
#include "log_rows.hpp"
#include "motion_row.hpp"
#include "scan_row.hpp"
#include "slam_core/grid_map/grid_file.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

// A particle filter with occupancy grids, without ROS: a line for each scan, "pose STAMP_NS X Y
// THETA" of the robot in the map [m, m, rad], and the map of the best particle as map_server reads
// it. Rows of the log, in the order of time, of which a scan is taken where the motion before it
// ends; '#' begins a comment:
//   motion START_NS END_NS X Y THETA  DX DY DTHETA  SX SY STHETA    as slam_core_wheel_log prints
//   it scan STAMP_NS ANGLE_MIN ANGLE_INCREMENT RANGE_MIN RANGE_MAX RANGE...    [rad, rad, m, m, m]

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} LOG.txt MAP.yaml [SECTION.KEY=VALUE]...\n"
    "  MAP.yaml     is written, and the image MAP.pgm beside it\n"
    "  SECTION.KEY  of a product's or robot's file: pf.particles=30\n";

void run(const std::string& path, const std::string& map, std::vector<std::string> overrides) {
  Settings settings({}, {}, std::move(overrides));
  particle_filter::FastSlam filter;
  as<MapChooser>(filter).useMap(MapKind::kGrid);
  filter.seed(1);
  filter.configure(settings);
  ScanRows scans(settings);
  settings.requireAllRead();
  LogRows row(path);
  while (row.next()) {
    if (row.kind() == "motion") give(motionIn(row), filter);
    if (row.kind() != "scan") continue;
    const auto scan = scans.scanIn(row);
    give(scan, filter);
    if (const auto status = filter.execute(); !status.isOk()) row.tell(status.message);
    fmt::print("{}", poseRow(scan.stamp, filter.pose().pose));
  }
  const auto grid = as<GridMapper>(filter).grid().value();
  if (grid.cells.empty())
    throw std::runtime_error("the log " + path + " holds no scan that tells anything");
  grid_map::saveGrid(map, grid);
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, slam::kUsage, argv[0]);
    return 2;
  }
  std::vector<std::string> overrides = {slam::kLaserAtOrigin};
  overrides.insert(overrides.end(), argv + 3, argv + argc);
  return slam::exitCodeOf([&] { slam::run(argv[1], argv[2], overrides); });
}
