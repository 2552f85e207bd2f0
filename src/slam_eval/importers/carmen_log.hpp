// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "laser_messages.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::eval {

/// A CARMEN log (Montemerlo, Roy, Thrun 2003) in file order, which is the physical one, with the
/// stamps as they stand there.
struct CarmenLog {
  /// A scan of the front laser with the raw odometry of its time.
  struct Scan {
    std::int64_t stamp = 0;  // [ns]
    Pose2 odometry;
    LaserReading reading;
    std::size_t odometry_before = 0;  // lines of ODOM that stand before it
  };
  struct Odometry {
    std::int64_t stamp = 0;  // [ns]
    Pose2 pose;
    double forward = 0.0, angular = 0.0;  // [m/s, rad/s]
  };

  std::vector<Scan> scans;
  std::vector<Odometry> odometry;
  std::string scan_kind;  // FLASER or ROBOTLASER1
  Pose2 T_base_laser;
  std::map<std::string, std::size_t> left_out;  // lines of other kinds
  std::size_t bad_lines = 0;
  std::string first_bad_line;  // where and why
};

/// @param max_range [m] at and beyond which a range is none; without it what the log says, at most
/// the 80 m of a SICK LMS
/// @throw UsageError no such file; ImportError no scans
CarmenLog readCarmen(const std::string& path, std::optional<double> max_range);

}  // namespace slam::eval
