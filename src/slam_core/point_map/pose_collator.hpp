// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/stamped_queue.hpp"
#include "slam_core/models/filter_pose.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::point_map {

/// Finds the robot's pose for each scan, whatever the order of arrival: the filter's latest pose at
/// or before the scan's stamp, extrapolated by motion. A scan waits until the filter has reported a
/// pose at or after its stamp, and motion covers it. Of several poses of one stamp the first
/// counts.
///
/// Poses and motion are kept for scans that come later than those, as of a link that was cut: by
/// their number, as the stamps of what is late are in order.
///
/// Counted: those of a StampedQueue, "before_pose" (a scan before the first pose), "before_motion"
/// (a scan after a pose from which no motion leads to it, as the first one came later), "restart";
/// a scan that comes after kKept poses or motions younger than it may be "late".
class PoseCollator {
 public:
  struct Placed {
    LaserScan scan;
    Pose2 T_map_base;
    bool restart = false;  ///< time started over, drop everything first
  };

  void push(Motion motion);
  void push(const FilterPose& pose);
  void push(LaserScan scan);

  /// The next scan that is due, or nothing. Call until it is empty after every push().
  std::optional<Placed> next();

  const Counters& counters() const { return counters_; }
  /// Messages that went back in time and wait for the other sources to do so as well.
  std::size_t setAside() const {
    return motions_.setAside() + poses_.setAside() + scans_.setAside();
  }
  std::optional<Stamp> lastMotion() const { return motions_.stamps().last(); }
  std::optional<Stamp> lastPose() const { return poses_.stamps().last(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(motions_, poses_, scans_, begin_, pose_, pose_sequence_, restart_, counters_);
  }

 private:
  static constexpr std::size_t kKept = 20000;  ///< minutes
  static constexpr std::size_t kScans = 2000;

  void forgetOldest();
  void takePoses(Stamp up_to);
  /// Why the pose of a scan is unknown; empty: it is known.
  std::string hindranceAt(Stamp stamp) const;
  Pose2 carriedTo(Stamp stamp);
  void restartWhenAllWentBack();

  StampedQueue<Motion> motions_{kKept};
  StampedQueue<FilterPose> poses_{kKept};
  StampedQueue<LaserScan> scans_{kScans};
  std::optional<Stamp> begin_;      ///< of the first motion
  std::optional<FilterPose> pose_;  ///< the last one not after the scan in hand
  std::uint64_t pose_sequence_ = 0;
  bool restart_ = false;
  Counters counters_;
};

}  // namespace slam::point_map
