// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/scan_matching/motion_prior.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::scan_matching {

/// The time between scans, for who has only their stamps to go by. A laser sweeps at a steady rate,
/// while some drivers stamp in lumps: stamps that are all over the place show the mean rate only.
class SweepInterval {
 public:
  void note(Duration interval);
  /// An interval that is stamped so, or what it is more likely to be.
  Duration plausible(Duration interval) const;
  /// A gap of any length counts in full here, since scans may have been lost.
  Duration likely(Duration interval) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(usual_, spread_);
  }

 private:
  double usual_ = 0.0, spread_ = 0.0;  ///< mean, and mean distance from it [s]; 0: none yet
};

/// The robot's motion from one scan to the next.
struct ScanStep {
  Pose2 increment;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta) of the increment
  /// Jacobian of the increment's error by the error of the reported motion: the part that the scan
  /// has not removed.
  Eigen::Matrix3d of_motion = Eigen::Matrix3d::Identity();

  template <class Archive>
  void persist(Archive& archive) {
    archive(increment, covariance, of_motion);
  }
};

/// The robot moves no faster than this.
struct MotionLimits {
  double speed = 10.0, turn_rate = 10.0;  ///< [m/s], [rad/s]
  bool may_jump = true;                   ///< a scan may find it far from where it was
};

/// Follows a robot through a map from scan to scan: each is looked for where the last pose and the
/// motion since then lead, or the last velocity where no motion is known.
class ScanTracker {
 public:
  explicit ScanTracker(const MatcherConfig& config = {}, const MotionLimits& limits = {})
      : matcher_(config), limits_(limits) {}

  /// The robot is there; what was known of its velocity, slips and the scans' stamps is dropped.
  void restart(const PoseEstimate& place);
  /// @param motion since the last scan @return what the scan fits; an empty map fits nothing
  Match track(const MapView& map, const ScanLevels& scan, Stamp stamp,
              const std::optional<Motion>& motion);

  /// The same robot in another map, or where something else has put it since the last scan.
  void moveTo(const Pose2& pose) { robot_.pose = pose; }
  /// The part of the map around the robot has just been drawn from its pose: relative to this part,
  /// the covariance of the pose becomes zero.
  void anchor() { robot_.covariance.setZero(); }

  /// To the last scan. What both poses owe to the map they were found in cancels; where a scan says
  /// nothing, as along a corridor, its covariance is that of the reported motion.
  const ScanStep& step() const { return step_; }
  /// At the last scan; the covariance is that among the map's parts around it, in (x, y, theta).
  const PoseEstimate& robot() const { return robot_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(robot_, step_, slip_, stamp_, wide_search_, sweeps_, velocity_, shares_, was_known_,
            unconfirmed_);
  }

 private:
  Motion motionOf(Duration interval) const;
  Match move(const Motion& motion);
  Match match(const MapView& map, const ScanLevels& scan, Stamp stamp, const Motion& motion,
              bool is_told);
  /// A wide search for each scan of a lost robot would take too long.
  bool mayUseWideWindow(Stamp stamp) const;
  /// The pose that follows from what is known before a scan, `noise` that of the motion to it.
  void update(const Match& found, const PosePrior& prior, const Motion& motion,
              const Eigen::Matrix3d& noise);
  /// The step to the last scan shows a velocity where both of its poses were known. Else it
  /// corrects the first of them.
  void learnVelocity(const Pose2& step, Duration interval, bool is_correction);

  ScanToMapMatcher matcher_;
  MotionLimits limits_;
  PoseEstimate robot_;
  ScanStep step_;
  SlipEstimate slip_;
  std::optional<Stamp> stamp_;        ///< of the last scan
  std::optional<Stamp> wide_search_;  ///< the last time
  SweepInterval sweeps_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< of the body [m/s, m/s, rad/s]
  Eigen::Vector3d shares_ = Eigen::Vector3d::Zero();    ///< of a usual step, what the last scan
                                                        ///< determines in each direction
  /// The last scan determined the pose in these directions.
  Eigen::Array<bool, 3, 1> was_known_ = Eigen::Array<bool, 3, 1>::Constant(true);
  /// Time since a scan confirmed each component of the velocity [s].
  Eigen::Array3d unconfirmed_ = Eigen::Array3d::Zero();
};

/// Says when the robot has gone or turned far enough for a scan to show something new.
class InsertionTrigger {
 public:
  /// @param distance [m] @param angle [rad]
  InsertionTrigger(double distance, double angle) : distance_(distance), angle_(angle) {}

  bool isDue(const Pose2& pose) const;
  void note(const Pose2& inserted) { last_ = inserted; }
  void restart() { last_.reset(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_);
  }

 private:
  double distance_, angle_;
  std::optional<Pose2> last_;
};

}  // namespace slam::scan_matching
