// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <string>
#include <vector>

#include "rawlog_log.hpp"

namespace slam::eval {

/// The beams of a scan counter-clockwise: +Inf where the laser saw nothing, NaN where the log marks
/// a range as invalid. Nothing for a scan of fewer than two beams or without an angle.
std::optional<LaserReading> toReading(const mrpt::obs::CObservation2DRangeScan& scan);

/// Tells the lasers of a log apart, by their label and their place on the robot.
class RawlogLasers {
 public:
  /// Index of the laser that made the scan, which counts for it.
  std::size_t add(const mrpt::obs::CObservation2DRangeScan& scan);

  const std::vector<RawlogLog::Laser>& all() const { return lasers_; }

 private:
  std::vector<RawlogLog::Laser> lasers_;
};

/// The main laser: of those that are level the one that looks ahead most, then that with most
/// scans.
/// @return its index; nothing where there is none
std::optional<std::size_t> mainLaser(const std::vector<RawlogLog::Laser>& lasers);

}  // namespace slam::eval
