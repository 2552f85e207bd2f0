// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/turn.hpp"
#include "slam_core/scan_matching/motion_prior.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

namespace slam::scan_matching {

/// Estimates the time between scans from their stamps. A laser sweeps at a steady rate, but some
/// drivers stamp several scans at once: irregular stamps show only the mean rate.
class SweepInterval {
 public:
  void note(Duration interval);
  /// The given interval, or the mean one if the stamps are irregular; at most three times the mean.
  Duration plausible(Duration interval) const;
  /// The same without that limit, since a gap may be long when scans were lost.
  Duration likely(Duration interval) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(usual_, spread_);
  }

 private:
  double usual_ = 0.0, spread_ = 0.0;  ///< mean, and mean deviation [s]; 0: none yet
};

/// The robot's motion from one scan to the next.
struct ScanStep {
  Pose2 increment;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta) of the increment
  /// Jacobian of the increment's error by the error of the reported motion: the part of that error
  /// that the scan has not removed.
  Eigen::Matrix3d of_motion = Eigen::Matrix3d::Identity();

  template <class Archive>
  void persist(Archive& archive) {
    archive(increment, covariance, of_motion);
  }
};

/// The robot moves no faster than this.
struct MotionLimits {
  double speed = 10.0, turn_rate = 10.0;  ///< [m/s], [rad/s]
  bool may_jump = true;                   ///< a scan may find the robot far from where it was
};

/// Tracks a robot through a map from scan to scan. Each scan is searched at the pose predicted from
/// the last pose and the motion since then, or from the last velocity if no motion is known.
///
/// A single motion that is less certain than 1 m or 0.5 rad, as that of a gap in odometry, leaves
/// the robot anywhere around. Then the place where a scan fits next to the prediction is one of
/// several, and the true one need not be in the map yet. So no scan is matched any more, until the
/// robot is put somewhere (restart()), or the map is drawn from its pose (anchor()).
class ScanTracker {
 public:
  explicit ScanTracker(const MatcherConfig& config = {}, const MotionLimits& limits = {})
      : matcher_(config), limits_(limits) {}

  /// Starts at this pose; the velocity, the slip and the stamps known so far are dropped.
  void restart(const PoseEstimate& place);
  /// @param motion since the last scan
  /// @param drift covariance of the surfaces around the robot relative to the oldest ones, which it
  /// may meet again; nothing if the map is fixed, or too small to have drifted
  /// @return what the scan fits; an empty map fits nothing
  Match track(const MapView& map, const ScanLevels& scan, Stamp stamp,
              const std::optional<Motion>& motion,
              const std::optional<Eigen::Matrix3d>& drift = std::nullopt);
  /// The same where nothing but the turn since the last scan is known, as from a gyro.
  Match track(const MapView& map, const ScanLevels& scan, Stamp stamp, const Turn& turn);

  /// @return the surfaces that the ends of a scan fit; to be called after track() with this scan
  std::vector<FittedEnd> fittedEnds(const MapView& map, const ScanLevels& scan) const {
    return matcher_.fittedEnds(map, scan, robot_.pose);
  }

  /// Moves the robot, for example into another map, or because something else has changed its pose
  /// since the last scan.
  void moveTo(const Pose2& pose) { robot_.pose = pose; }
  /// The part of the map around the robot has just been drawn from its pose: relative to this part,
  /// the covariance of the pose becomes zero.
  void anchor() {
    robot_.covariance.setZero();
    is_anywhere_ = false;
  }

  /// The motion to the last scan. Errors that both poses share, since they were found in the same
  /// map, cancel. In directions that the scan does not determine, such as along a corridor, its
  /// covariance is that of the reported motion.
  const ScanStep& step() const { return step_; }
  /// The pose at the last scan. The covariance is relative to the parts of the map around it, in
  /// (x, y, theta).
  const PoseEstimate& robot() const { return robot_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(robot_, step_, slip_, stamp_, wide_search_, sweeps_, velocity_, shares_, was_known_,
            unconfirmed_, is_anywhere_);
  }

 private:
  /// The times since the last scan.
  struct Intervals {
    Duration plausible{}, likely{};  ///< as SweepInterval says
  };
  Intervals intervalsTo(Stamp stamp);
  Motion motionOf(Duration interval, const std::optional<Turn>& turn) const;
  /// The way since the last scan.
  struct Way {
    const Motion& motion;
    bool is_told;  ///< or else extrapolated from the last velocity
    const std::optional<Eigen::Matrix3d>& drift;
    bool has_turn = false;  ///< a sensor that does not slip measured the turn
  };
  Match follow(const MapView& map, const ScanLevels& scan, Stamp stamp, const Way& way,
               Duration gap);
  Match move(const Motion& motion);
  Match match(const MapView& map, const ScanLevels& scan, Stamp stamp, const Way& way);
  /// A wide search for each scan of a lost robot would take too long.
  bool mayUseWideWindow(Stamp stamp) const;
  /// Updates the pose by a match. @param noise of the motion to the scan
  void update(const Match& found, const PosePrior& prior, const Motion& motion,
              const Eigen::Matrix3d& noise);
  /// The step to the last scan gives a velocity if both of its poses were known. Otherwise it
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
  bool is_anywhere_ = false;  ///< a motion of which little is known has led the robot anywhere
};

/// Tells when the robot has moved or turned far enough for a scan to show something new.
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
