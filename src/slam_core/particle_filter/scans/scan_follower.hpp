// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/motion.hpp"
#include "slam_core/scan_matching/scan_map.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"

namespace slam::particle_filter {

/// Follows the robot from scan to scan in the map of the most likely particle, once for all: what
/// wheels did wrong between two updates is put right before any particle moves.
class ScanFollower {
 public:
  /// Standard deviations by which the way that was followed errs after a metre [m, rad].
  struct Drift {
    double position, heading;
  };
  ScanFollower(const scan_matching::MatcherConfig& matcher, const Drift& drift);

  /// Nothing is known of the way so far.
  void restart();
  /// What the wheels say of the way to the next scan.
  void move(const Motion& motion);
  /// @param map of the particle that is followed
  /// @param pose where the wheels have put it
  /// @return what the scan fits there
  scan_matching::Match follow(const scan_matching::MapView& map,
                              const scan_matching::ScanLevels& scan, Stamp stamp,
                              const Pose2& pose);

  /// Where the last scan has put the robot, seen from where the wheels did.
  const Pose2& correction() const { return correction_; }
  /// Since the last restart() or beginMotion(); its covariance is what scans leave of that of the
  /// wheels, and the drift of the map that they were matched with.
  const Motion& motion() const { return motion_; }
  void beginMotion() { motion_ = {}; }

 private:
  Eigen::Vector3d variance_per_metre_;
  scan_matching::ScanTracker tracker_;
  std::optional<Motion> wheels_;  ///< since the last scan
  Pose2 correction_;
  Motion motion_;
};

}  // namespace slam::particle_filter
