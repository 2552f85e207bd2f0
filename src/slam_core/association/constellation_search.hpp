// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/association/constellation_evidence.hpp"

namespace slam::association {

/// Finds the robot in a map by the relative positions of the landmarks around it (consensus:
/// Fischler and Bolles 1981). Each pair of them that is as far apart as a pair of the map suggests
/// a pose; the poses that most pairs suggest are weighed by all landmarks.
class ConstellationSearch {
 public:
  /// @param map outlives this @param outlier_share as ConstellationEvidence
  ConstellationSearch(const LandmarkMap& map, double outlier_share);

  /// Places that are apart from one another, the most likely first.
  /// @param reach as ConstellationEvidence::near(); one that has seen nothing expects nothing
  std::vector<Place> placesOf(const std::vector<LocalLandmark>& around,
                              const SensorReach& reach = {}) const;
  const ConstellationEvidence& evidence() const { return evidence_; }

 private:
  /// Two landmarks of the map.
  struct MapPair {
    double distance;  ///< [m]
    std::size_t first, second;
  };

  void suggest(const LocalLandmark& a, const LocalLandmark& b, std::vector<Pose2>& poses) const;
  std::vector<Pose2> suggestions(const std::vector<LocalLandmark>& around) const;

  const LandmarkMap& map_;
  ConstellationEvidence evidence_;
  std::vector<MapPair> pairs_;  ///< by their distance
};

}  // namespace slam::association
