// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/association/constellation_evidence.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::relocalisation {

/// The places at which a lost robot may be: the odds of each against being beyond the map have
/// reached the limit since the search began. If places look alike, as under a
/// ceiling of tiles, small random differences decide which of them has more evidence, and a place
/// loses evidence as soon as the robot would have left the map there. So each place is moved with
/// the robot, and remains until the map contradicts it (multiple hypotheses: Jensfelt and
/// Kristensen 2001). Driving beyond the border of the map contradicts no place.
class RivalPlaces {
 public:
  void move(const Motion& motion);
  void forget() { poses_.clear(); }
  /// Adds places that the last search has found, and with each new one those to which the map's
  /// repeats lead from there, in the map or beyond it.
  /// @param repeats as of repeatsOf()
  void add(const std::vector<Pose2>& places, const std::vector<Pose2>& repeats);
  /// Removes places that are contradicted.
  void check(const association::ConstellationEvidence& evidence,
             const std::vector<association::LocalLandmark>& around,
             const association::SensorReach& reach);
  /// Whether the robot may be at another place than this one.
  bool hasOtherThan(const Pose2& place) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(poses_);
  }

 private:
  /// @return whether it is a new one
  bool add(const Pose2& place);

  std::vector<Pose2> poses_;  ///< T_map_base now
};

}  // namespace slam::relocalisation
