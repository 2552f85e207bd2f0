// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::relocalisation {

/// Judges whether what a laser sees changes suddenly: the robot was carried away, as ViewChange
/// does for landmarks. No map is needed, so that it is noticed where the map has nothing to
/// contradict, too.
///
/// Each scan is compared with the last one, moved on by odometry. Two that were taken a moment
/// apart see the same surfaces, but for a few beams. In another place many beams end before the
/// surfaces of the last scan, and others pass through them. Somebody who steps before the laser
/// only hides surfaces, and shows none behind them. A damaged scan is unlike those after it, too:
/// three scans in a row have to be alike, and unlike the last one before them. Without odometry,
/// and where it is uncertain, nothing is judged.
class ScanChange {
 public:
  enum class Verdict {
    kGoesOn,  ///< it is like the last scan, or cannot be compared with it
    kUnlike,  ///< it is unlike the last scan, which may mean nothing yet
    kChanged  ///< the robot has been carried away
  };

  void move(const Motion& motion);
  Verdict judge(const LaserScan& scan);
  /// The next scan is compared with none before it.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_, unlike_, count_);
  }

 private:
  /// A scan that others are compared with.
  struct Seen {
    LaserScan scan;
    PoseEstimate place;     ///< of the robot then, in its frame now
    bool is_moved = false;  ///< a motion has come since

    template <class Archive>
    void persist(Archive& archive) {
      archive(scan, place.pose, place.covariance, is_moved);
    }
  };

  static void move(const Motion& motion, std::optional<Seen>& seen);
  static bool isComparable(const Seen& seen);
  static bool areUnlike(const Seen& seen, const LaserScan& scan);

  std::optional<Seen> last_;    ///< the last one that was like that before it
  std::optional<Seen> unlike_;  ///< the last one that was not
  int count_ = 0;               ///< how many in a row were unlike it, but like each other
};

}  // namespace slam::relocalisation
