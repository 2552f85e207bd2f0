// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "slam_core/grid_map/scan_points.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/particle_filter/proposal.hpp"

namespace slam::particle_filter {

/// What one step of the filter works with.
struct Step {
  Stamp stamp;
  std::optional<Motion> motion;  ///< since the particles were moved last
  std::optional<Motion> latest;  ///< its part since the last step
  std::optional<grid_map::ScanPoints> scan;
  Sight sight;
  std::vector<LandmarkObservation> unseen;  ///< of landmarks that are in no map yet

  std::vector<PoseGaussian> priors, proposals;  ///< one for each particle
  PoseEstimate moments;                         ///< of the particles, once they are weighed
  std::vector<double> log_factors;              ///< one for each particle
  std::vector<Prediction> predictions;          ///< all of particle 0, then of particle 1, ...
  std::vector<std::uint32_t> ancestors;  ///< whose prior, proposal and predictions a particle has
  bool is_lost = false;
  bool is_mapped = false;    ///< the scan has gone into the particles' grids
  bool is_doubtful = false;  ///< the maps of landmarks stay as they are

  bool isNothing() const { return !motion && !hasSeen(); }
  bool hasSeen() const { return hasSeenLandmarks() || scan; }
  bool hasSeenLandmarks() const { return !sight.matches.empty() || !unseen.empty(); }
  /// Whether what was seen tells the particles apart.
  bool weighs() const { return !sight.matches.empty() || scan; }
  /// Room for the particles' results.
  void resize(std::size_t particles);
  Prediction* predictionsOf(std::size_t i) { return predictions.data() + i * sight.matches.size(); }
  const Prediction* predictionsOf(std::size_t i) const {
    return predictions.data() + i * sight.matches.size();
  }
};

inline void Step::resize(std::size_t particles) {
  priors.resize(particles);
  proposals.resize(particles);
  log_factors.resize(particles);
  predictions.resize(particles * sight.matches.size());
}

}  // namespace slam::particle_filter
