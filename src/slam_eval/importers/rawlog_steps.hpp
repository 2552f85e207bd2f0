// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <optional>
#include <string>
#include <vector>

#include "rawlog_log.hpp"

namespace slam::eval {

/// What one object of a rawlog says, in file order and with the log's own stamp.
struct RawlogStep {
  std::int64_t stamp = 0;  // [ns], 0: missing
  std::size_t frame = 0;  // index of its sensory frame (or observation), of odometry the next one's
  bool ends_frame = false;  // a frame or observation, not odometry alone: the clock ticks
  std::optional<RawlogLog::Odometry> odometry;
  std::optional<RawlogLog::Sighting> sighting;
  std::optional<RawlogLog::Scan> scan;
};

struct RawlogSteps {
  std::vector<RawlogStep> steps;
  bool has_actions = false;         // odometry as increments between frames
  bool begins_with_action = false;  // before the first frame
  std::size_t frames = 0;
  std::size_t left_out_odometry = 0;
  std::size_t left_out_readings = 0;
  std::size_t left_out_scans = 0;
  std::vector<RawlogLog::Laser> lasers;
  std::size_t other_objects = 0;
};

/// @throw ImportError no odometry, or motion in space
RawlogSteps makeRawlogSteps(const std::vector<mrpt::serialization::CSerializable::Ptr>& objects,
                            const std::string& path);

}  // namespace slam::eval
