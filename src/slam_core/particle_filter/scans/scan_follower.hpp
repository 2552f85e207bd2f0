// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/motion.hpp"
#include "slam_core/scan_matching/scan_map.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"

namespace slam::particle_filter {

/// What a scan says of the way that the wheels have led since the scan before.
struct ScanCorrection {
  Pose2 pose;  ///< where it puts the robot, seen from where the wheels did
  /// The part of an error of the wheels that it leaves, (x, y, theta) in the robot's frame.
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity();

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose, left);
  }
};

/// The motion up to a scan with what that says of it.
Motion corrected(const Motion& motion, const ScanCorrection& correction);
/// What is left of `deviation`, by which a particle has strayed before `motion` up to the scan.
Pose2 corrected(const Pose2& deviation, const Pose2& motion, const ScanCorrection& correction);

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
  /// @param pose where the wheels have put it @param drift see ScanTracker::track()
  /// @return what the scan fits there
  scan_matching::Match follow(const scan_matching::MapView& map,
                              const scan_matching::ScanLevels& scan, Stamp stamp, const Pose2& pose,
                              const std::optional<Eigen::Matrix3d>& drift);

  /// Of the last scan.
  const ScanCorrection& correction() const { return correction_; }
  /// Since the last restart() or beginMotion(); its covariance is what scans leave of that of the
  /// wheels, and the drift of the map that they were matched with.
  const Motion& motion() const { return motion_; }
  void beginMotion() { motion_ = {}; }
  /// Its covariance, in (x, y, theta), is that relative to the parts of the map around it.
  const PoseEstimate& robot() const { return tracker_.robot(); }
  /// @return the surfaces that the ends of a scan fit; to be called after follow() with this scan
  std::vector<scan_matching::FittedEnd> fittedEnds(const scan_matching::MapView& map,
                                                   const scan_matching::ScanLevels& scan) const {
    return tracker_.fittedEnds(map, scan);
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(tracker_, wheels_, correction_, motion_);
  }

 private:
  Eigen::Vector3d variance_per_metre_;
  scan_matching::ScanTracker tracker_;
  std::optional<Motion> wheels_;  ///< since the last scan
  ScanCorrection correction_;
  Motion motion_;
};

}  // namespace slam::particle_filter
