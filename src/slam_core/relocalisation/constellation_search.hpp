// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/relocalisation/place_evidence.hpp"

namespace slam::relocalisation {

/// Finds the robot in a map by the relative positions of the landmarks around it (consensus:
/// Fischler and Bolles 1981). Each pair of them that is as far apart as a pair of the map suggests
/// a pose; the poses that most pairs suggest are weighed by all landmarks.
class ConstellationSearch {
 public:
  /// @param map outlives this object @param outlier_share see PlaceEvidence
  ConstellationSearch(const LandmarkMap& map, double outlier_share);

  /// Places that are distinct (areOnePlace()), the most likely first.
  /// @param reach see PlaceEvidence::near(); without sightings it expects no landmark
  std::vector<Place> placesOf(const std::vector<LocalLandmark>& around,
                              const association::SensorReach& reach = {}) const;
  const PlaceEvidence& evidence() const { return evidence_; }

 private:
  /// Two landmarks of the map.
  struct MapPair {
    double distance;  ///< [m]
    std::size_t first, second;
  };

  void suggest(const LocalLandmark& a, const LocalLandmark& b, std::vector<Pose2>& poses) const;
  std::vector<Pose2> suggestions(const std::vector<LocalLandmark>& around) const;

  const LandmarkMap& map_;
  PlaceEvidence evidence_;
  std::vector<MapPair> pairs_;  ///< sorted by their distance
};

}  // namespace slam::relocalisation
