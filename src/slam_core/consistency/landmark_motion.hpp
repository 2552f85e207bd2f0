// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/consistency/scale_doubt.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// The motion of a landmark sensor by what it sees alone: the rigid motion between the landmarks at
/// the beginning of a piece of the way and the same ones at its end, weighted least squares. No
/// filter is involved. One that trusts its odometry turns the robot until the bearings fit it, so
/// that its own way shows only a part of what a sensor that is mounted otherwise than configured
/// does to the direction of motion (hand-eye calibration: Censi et al. 2013 find wheels and mount
/// by it).
///
/// Only points with ids are used. A piece is left out where its landmarks did not move as a rigid
/// body, as where their ids are false or some of them have moved, and where odometry and landmarks
/// have nothing in common (WayContradiction is for that).
class LandmarkMotion {
 public:
  /// To be called with each motion before the observations at its end.
  void predict(const Motion& motion) {
    odometry_ = odometry_ ? joined(*odometry_, motion) : motion;
  }
  /// @param array with covariances
  /// @return the piece of the way that ends with these observations, where there is one
  std::optional<PieceOfWay> see(const LandmarkObservationArray& array);

  template <class Archive>
  void persist(Archive& archive) {
    archive(begin_, odometry_);
  }

 private:
  std::optional<LandmarkObservationArray> begin_;  ///< what was seen where the piece begins
  std::optional<Motion> odometry_;                 ///< since then
};

}  // namespace slam
