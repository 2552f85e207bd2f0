// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/models/motion.hpp"
#include "slam_core/relocalisation/scan_profile.hpp"

namespace slam::relocalisation {

/// Judges by what a laser sees whether the robot was carried away a moment before. ViewChange does
/// the same with landmarks. No map is needed, so that it is noticed beyond the map, too.
///
/// Each scan is compared with the last one, which odometry moves on. In another place most scans
/// are unlike it (areUnlike()). A damaged scan is unlike those after it, too. So the last scan has
/// to be like the one before it, and three later scans in at least 0.3 s have to be unlike it and
/// like each other. Scans are not compared without odometry, where it is uncertain, and after 5 s
/// without a scan: in that time, doors open and people come.
class ScanChange {
 public:
  enum class Verdict {
    kGoesOn,  ///< it is like the last scan, or cannot be compared with it
    kUnlike,  ///< it is unlike the last scan, which may mean nothing yet
    kChanged  ///< the robot was carried away
  };

  void move(const Motion& motion);
  Verdict judge(const LaserScan& scan);
  /// The next scan is compared with none before it.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_, is_confirmed_, unlike_, count_, unlike_since_);
  }

 private:
  /// A scan that later ones are compared with.
  struct Reference {
    ScanProfile profile;
    Pose2 sensor_pose;  ///< T_base_sensor
    std::string sensor_frame;
    Stamp stamp;
    std::optional<Motion> since;  ///< from this scan to now

    template <class Archive>
    void persist(Archive& archive) {
      archive(profile, sensor_pose, sensor_frame, stamp, since);
    }
  };

  static bool isComparable(const Reference& before, const Reference& now);
  static bool isUnlike(const Reference& before, const Reference& now);
  void restartFrom(Reference now);
  /// @return whether as many scans in a row as suffice are unlike the last one
  bool addUnlike(Reference now);

  std::optional<Reference> last_;    ///< the last scan that was not unlike the one before it
  bool is_confirmed_ = false;        ///< whether last_ is like the one before it
  std::optional<Reference> unlike_;  ///< the newest scan, if it is unlike last_
  int count_ = 0;                    ///< scans that are unlike last_, and each like the one before
  Stamp unlike_since_;               ///< stamp of the first of them
};

}  // namespace slam::relocalisation
