// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slam::eval {

/// Robot @p robot of a UTIAS MRCLAM data set (Leung, Halpern, Barfoot, Liu, IJRR 30(8) 2011):
/// what its text files hold, sorted by stamp, landmarks under their subject numbers.
struct MrclamLog {
  struct Velocity {
    std::int64_t stamp;  // [ns]
    double forward;      // [m/s]
    double angular;      // [rad/s]
  };
  struct Reading {
    std::int64_t landmark;  // subject number
    double range;           // [m]
    double bearing;         // [rad]
  };
  /// The readings of one stamp. It may be empty: the camera looked, and saw no landmark.
  struct Sighting {
    std::int64_t stamp;  // [ns]
    std::vector<Reading> readings;
  };
  struct Pose {
    std::int64_t stamp;  // [ns]
    double x, y, theta;  // [m, m, rad]
  };
  struct Landmark {
    std::int64_t id;  // subject number
    double x, y;      // [m]
  };

  std::vector<Velocity> odometry;
  std::vector<Sighting> sightings;
  std::vector<Pose> truth;
  std::vector<Landmark> landmarks;

  std::size_t out_of_order = 0;       // rows of all files that had to be sorted
  std::size_t replaced_odometry = 0;  // odometry rows followed by another one of the same stamp
  std::size_t robot_readings = 0;     // dropped readings of other robots
  std::size_t unknown_readings = 0;   // dropped readings of barcodes that are not in Barcodes.dat
};

/// @throw UsageError folder or robot is not there; ImportError a file is missing or wrong
MrclamLog readMrclam(const std::string& folder, int robot);

}  // namespace slam::eval
