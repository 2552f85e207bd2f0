// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam::particle_filter {

/// What a particle takes the observations of one stamp for.
struct Sight {
  struct Match {
    std::size_t slot;    ///< of the landmark in the particle's map
    std::size_t column;  ///< of the observation among the predictions, which all particles share
    LandmarkObservation z;
  };
  Pose2 sensor;  ///< T_base_sensor
  std::vector<Match> matches;
  double gate = 0.0;  ///< largest squared Mahalanobis distance of a match that counts
  /// Observations of landmarks that are not in the particle's map yet, by their place in the array.
  std::vector<std::size_t> unseen;
  /// What each observation of the array is taken for.
  std::vector<association::Decision::Kind> kinds;

  bool isEmpty() const { return matches.empty() && unseen.empty(); }
};

}  // namespace slam::particle_filter
