// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "laser_messages.hpp"
#include "slam_core/common/progress.hpp"

namespace slam::eval {

/// Odometry, range-bearing observations and scans of the main laser of an MRPT rawlog of either
/// format.
///
/// In pairs of actions and sensory frames an action is the motion up to the frame behind it: the
/// odometry pose is the composition of the increments so far, stamped like the frame. Where an
/// action comes first, the pose before it lies kStepTime before the first frame. In a log of single
/// observations the odometry poses have stamps of their own.
struct RawlogLog {
  static constexpr std::int64_t kStepTime = 100'000'000;      // [ns]
  static constexpr std::int64_t kClockStart = 1'000'000'000;  // of a made-up clock [ns]

  struct Odometry {
    std::int64_t stamp = 0;                  // [ns]
    double x = 0.0, y = 0.0, theta = 0.0;    // [m, m, rad]
    double vx = 0.0, vy = 0.0, omega = 0.0;  // where the log has them [m/s, m/s, rad/s]
  };
  struct Reading {
    std::int64_t id;                   // -1: not identified
    double range, bearing;             // in the horizontal plane [m, rad]
    std::array<double, 4> covariance;  // of (range, bearing); [0] = -1: unknown
  };
  struct Sighting {
    std::int64_t stamp = 0;                // [ns]
    std::size_t frame = 0;                 // counts the log's sensory frames (or observations)
    std::string sensor;                    // its frame id
    double x = 0.0, y = 0.0, theta = 0.0;  // of the sensor on the robot [m, m, rad]
    std::vector<Reading> readings;
  };

  struct Laser {
    std::string label;
    double x = 0.0, y = 0.0, z = 0.0;           // on the robot [m]
    double yaw = 0.0, pitch = 0.0, roll = 0.0;  // [rad]
    std::size_t scans = 0;
  };
  struct Scan {
    std::int64_t stamp = 0;  // [ns]
    std::size_t laser = 0;   // index into lasers
    LaserReading reading;
  };

  std::vector<Odometry> odometry;
  std::vector<Sighting> sightings;
  std::vector<Scan> scans;  // of the main laser
  std::vector<Laser> lasers;
  std::optional<std::size_t> main_laser;   // the level one that looks ahead most
  std::vector<std::int64_t> frame_stamps;  // of each frame, for the true path [ns]

  bool made_up_stamps = false;        // the log's own were missing, equal or closer than 5 ms
  std::size_t out_of_order = 0;       // observations that had to be sorted
  std::size_t left_out_odometry = 0;  // after the last frame, or beside the actions, or replaced
  std::size_t left_out_readings = 0;  // range or angle impossible
  std::size_t left_out_scans = 0;     // fewer than two beams, or no angle
  std::size_t other_objects = 0;      // of other sensors
};

/// @throw UsageError no such file; ImportError no rawlog, or one without planar odometry
RawlogLog readRawlog(const std::string& path, Progress& progress);

}  // namespace slam::eval
