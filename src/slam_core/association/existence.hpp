// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <set>
#include <vector>

#include "slam_core/association/sensor_reach.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::association {

/// A landmark of a map by its place.
struct LandmarkPlace {
  LandmarkId id = kUnknownId;
  Eigen::Vector2d position;  ///< map frame [m]
};

/// Whether the landmarks of a map exist (negative evidence, Montemerlo 2003, ch. 3): the log odds
/// of one grow when it is seen, and fall when it should be seen and is not. Each piece of the way
/// counts once, so that a robot that stands before an occluded landmark does not remove it. How
/// likely a landmark in view is seen is learnt from those that are well established.
///
/// Call order in a step: move(), then see() after the update.
class Existence {
 public:
  /// Those of a loaded map are established.
  explicit Existence(const LandmarkMap& map = {});

  void move(const Motion& motion);
  /// @param sensor T_map_sensor
  /// @param seen landmarks of the last array
  /// @return ghosts: landmarks to be removed, of which nothing is known from now on
  std::vector<LandmarkId> see(const Pose2& sensor, const std::vector<LandmarkPlace>& landmarks,
                              const std::vector<LandmarkId>& seen, const SensorReach& reach);
  /// Drops the evidence about a landmark that was removed.
  void forget(LandmarkId id) {
    log_odds_.erase(id);
    seen_.erase(id);
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(log_odds_, seen_, way_, turn_, hits_, misses_);
  }

 private:
  bool isDue() const;
  double detection() const;

  std::map<LandmarkId, double> log_odds_;
  std::set<LandmarkId> seen_;  ///< in this piece
  double way_ = 0.0, turn_ = 0.0;
  double hits_ = 1.0, misses_ = 1.0;  ///< of established landmarks
};

}  // namespace slam::association
