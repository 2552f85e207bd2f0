// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::relocalisation {

/// The ranges of one laser in the order of their bearings, so that those around a direction are
/// found fast.
class ScanProfile {
 public:
  /// The surfaces that the beams around a direction have met.
  struct Surfaces {
    double nearest = INFINITY, farthest = 0.0;  ///< [m]
    bool all_met = true;                        ///< whether each of these beams has met one
  };

  ScanProfile() = default;
  explicit ScanProfile(const LaserFan& fan);

  /// @return the number of beams that have met something
  std::size_t hits() const { return hits_; }
  const std::vector<LaserBeam>& beams() const { return beams_; }
  /// @param bearing in (-pi, pi] [rad] @return nothing outside the field of view
  std::optional<Surfaces> around(double bearing) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(beams_, hits_);
  }

 private:
  std::vector<LaserBeam> beams_;  ///< by their bearings in (-pi, pi]
  std::size_t hits_ = 0;
};

/// Whether two scans of one laser are of different surroundings: many beams of the later one end
/// well before the surfaces that the earlier one has met, and many others pass through them.
/// Somebody who steps before the laser only hides surfaces, and one who steps aside only uncovers
/// them.
/// @param T_before_now between the poses of the laser
bool areUnlike(const ScanProfile& before, const ScanProfile& now, const Pose2& T_before_now);

}  // namespace slam::relocalisation
