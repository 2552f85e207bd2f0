// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam::eval {

/// The columns of the Victoria Park data set (Guivant, Nebot 2001) as a folder's files hold them,
/// in the file's units. Rows are in file order.
struct VictoriaParkTables {
  struct Table {
    std::string path;
    std::vector<double> time;                  // [ms] or [s]
    std::vector<std::vector<double>> columns;  // each as long as time
  };
  Table laser;               // the ranges, one column a beam
  Table driving;             // speed, steering angle
  Table gps;                 // x, y; empty where there is none
  bool is_gps_named = true;  // false: the file does not say which of its columns is x
};

/// From the .mat files of a folder, else from its text files; README.md tells their names.
/// @throw UsageError no such folder; ImportError a file is damaged, or missing
VictoriaParkTables readVictoriaParkTables(const std::string& folder);

/// The data set in SI units, each list sorted by stamp without equal stamps.
struct VictoriaParkLog {
  struct Scan {
    std::int64_t stamp = 0;          // [ns]
    std::vector<float> ranges;       // [m], from right to left; +Inf: no return
    std::vector<float> intensities;  // [1], empty where the log has none
  };
  /// The robot's velocity in its frame: the middle of the rear axle, x ahead.
  struct Driving {
    std::int64_t stamp = 0;               // [ns]
    double forward = 0.0, angular = 0.0;  // [m/s, rad/s]
  };
  struct Fix {
    std::int64_t stamp = 0;   // [ns]
    double x = 0.0, y = 0.0;  // of the antenna, east and north [m]
  };

  std::vector<Scan> scans;
  std::vector<Driving> driving;
  std::vector<Fix> fixes;
  std::size_t left_out = 0;       // rows that hold no number, are late or stand twice
  bool are_axes_swapped = false;  // the GPS columns were north, east
};

/// @throw ImportError the tables hold what the vehicle cannot have measured
VictoriaParkLog makeVictoriaParkLog(const VictoriaParkTables& tables);

/// The pose of the rear axle's middle at each row of `driving`, from a start at the origin; a
/// velocity holds until the next row.
std::vector<Pose2> deadReckoning(const std::vector<VictoriaParkLog::Driving>& driving);

}  // namespace slam::eval
