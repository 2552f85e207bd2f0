// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/consistency/scale_doubt.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Estimates the motion of a landmark sensor from its observations alone: the rigid motion between
/// the landmarks at the beginning of a piece of the path and the same landmarks at its end, by
/// weighted least squares. No filter is involved: a filter that trusts its odometry turns the robot
/// until the bearings fit, so that its path shows only a part of the effect of a wrong mount on the
/// direction of motion (hand-eye calibration: Censi et al. 2013 calibrate wheels and mount by it).
///
/// Only points with ids are used. A piece is left out if its landmarks did not move as a rigid
/// body, because ids are false or some landmarks were moved, or if odometry and landmarks have
/// nothing in common (WayContradiction detects that).
class LandmarkMotion {
 public:
  /// To be called with each motion before the observations at its end.
  void predict(const Motion& motion) {
    odometry_ = odometry_ ? joined(*odometry_, motion) : motion;
  }
  /// @param array with covariances
  /// @return the piece of the path that ends with these observations, if there is one
  std::optional<PieceOfWay> see(const LandmarkObservationArray& array);

  template <class Archive>
  void persist(Archive& archive) {
    archive(begin_, odometry_);
  }

 private:
  std::optional<LandmarkObservationArray> begin_;  ///< at the beginning of the piece
  std::optional<Motion> odometry_;                 ///< since then
};

}  // namespace slam
