// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "log_rows.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/laser/scan_gate.hpp"

namespace slam {

/// "scan STAMP_NS ANGLE_MIN ANGLE_INCREMENT RANGE_MIN RANGE_MAX RANGE..." [rad, rad, m, m, m]; a
/// range of `inf` met nothing, `nan` tells nothing.
inline LaserSweep sweepIn(LogRows& row) {
  const auto next = [&row] { return static_cast<float>(row.number()); };
  LaserSweep sweep;
  sweep.stamp = stampFromNanoseconds(row.integer());
  sweep.angle_min = next();
  sweep.angle_increment = next();
  sweep.range_min = next();
  sweep.range_max = next();
  while (row.hasMore()) sweep.ranges.push_back(next());
  const auto steps = sweep.ranges.empty() ? 0 : sweep.ranges.size() - 1;
  sweep.angle_max = sweep.angle_min + static_cast<float>(steps) * sweep.angle_increment;
  return sweep;
}

/// Where the laser sits unless the user says otherwise: at the robot's origin, looking ahead.
constexpr const char* kLaserAtOrigin = "laser.sensor_pose=[0, 0, 0, 0, 0, 0]";

/// The scans of a log for a component that takes them seen from above.
class ScanRows {
 public:
  explicit ScanRows(Settings& settings) { gate_.configure(settings.read<LaserConfig>()); }

  LaserScan scanIn(LogRows& row) {
    gate_.set(sweepIn(row));
    if (const auto status = gate_.execute(); !status.isOk()) row.tell(status.message);
    return gate_.scan().value();
  }

 private:
  ScanGate gate_;
};

}  // namespace slam
