// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <string>
#include <vector>

#include "exit_code.hpp"
#include "log_rows.hpp"
#include "motion_row.hpp"
#include "scan_row.hpp"
#include "slam_core/point_map/pcd_file.hpp"
#include "slam_core/point_map/point_map.hpp"

// A map of the points where a laser's beams end, without ROS: prints it as a PCD file. Rows of the
// log, in any order of sources; '#' begins a comment:
//   motion START_NS END_NS X Y THETA  DX DY DTHETA  SX SY STHETA    as slam_core_wheel_log prints
//   it pose STAMP_NS X Y THETA                  of the robot in the map, a filter's [m, m, rad]
//   scan STAMP_NS ANGLE_MIN ANGLE_INCREMENT RANGE_MIN RANGE_MAX RANGE...    [rad, rad, m, m, m]

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} LOG.txt [SECTION.KEY=VALUE]... > POINTS.pcd\n"
    "  SECTION.KEY  of a product's or robot's file: point_map.fusion=aligned\n";

class PointMapLog {
 public:
  explicit PointMapLog(Settings& settings) : scans_(settings) { map_.configure(settings); }

  void take(LogRows& row) {
    if (row.kind() == "motion")
      takeMotion(motionIn(row));
    else if (row.kind() == "pose")
      takePose(row);
    else if (row.kind() == "scan")
      map_.set(scans_.scanIn(row));
    do {
      if (const auto status = map_.execute(); !status.isOk()) row.tell(status.message);
    } while (map_.isBusy());
  }

  const point_map::PointMap& map() const { return map_; }

 private:
  void takeMotion(Motion motion) {
    motion.sequence = motions_++;
    map_.set(std::move(motion));
  }

  void takePose(LogRows& row) {
    const auto stamp = stampFromNanoseconds(row.integer());
    map_.set(FilterPose::of(stamp, poseIn(row)));
  }

  ScanRows scans_;
  point_map::PointMap map_;
  std::uint64_t motions_ = 0;
};

void run(const std::string& path, std::vector<std::string> overrides) {
  Settings settings({}, {}, std::move(overrides));
  PointMapLog log(settings);
  settings.requireAllRead();
  LogRows row(path);
  while (row.next()) log.take(row);
  const auto counters = log.map().counters();
  for (const auto& [reason, count] : counters.all()) fmt::print(stderr, "{} x {}\n", count, reason);
  fmt::print("{}", point_map::toPcd(log.map().points()));
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, slam::kUsage, argv[0]);
    return 2;
  }
  std::vector<std::string> overrides = {slam::kLaserAtOrigin};
  overrides.insert(overrides.end(), argv + 2, argv + argc);
  return slam::exitCodeOf([&] { slam::run(argv[1], overrides); });
}
