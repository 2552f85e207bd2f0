// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/observation_model.hpp"
#include "slam_core/particle_filter/particles/landmark_estimate.hpp"

namespace slam::particle_filter {

/// What a particle expects an observation of a landmark of its map to be, linearised about a pose.
struct Expectation {
  Eigen::Vector2d nu;  ///< innovation, observation minus expectation
  Eigen::Matrix<double, 2, 3> H_robot;
  Eigen::Matrix2d H_landmark;
  Eigen::Matrix2d R;  ///< covariance of the innovation when the pose is exact: H_m P_m H_m^T + R_z
};

/// Nothing where the landmark lies too near the sensor for the Jacobians to mean anything.
std::optional<Expectation> expect(const ObservationModel& model, const Pose2& robot,
                                  const Pose2& sensor, const LandmarkEstimate& landmark,
                                  const LandmarkObservation& z);

/// One step of the landmark's own EKF, in Joseph's form: stays positive definite. Where the
/// observation is singular the estimate is returned as it was.
LandmarkEstimate updated(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                         const LandmarkEstimate& landmark, const LandmarkObservation& z);

/// An observation of a landmark of the map: updates it where it fits; else the landmark loses
/// credit and is re-initialised with this one when it has none left (after the evidence counter of
/// Montemerlo 2003, ch. 3). One that was seen by chance once where it is not does not stay there
/// for ever.
void takeSighting(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                  const LandmarkObservation& z, bool fits, LandmarkEstimate& landmark);

/// The policy of landmark initialisation: where a first observation puts the landmark, Eq. 5.4,
/// with the observation's noise mapped into the plane. The pose is exact: it is the particle's own.
LandmarkEstimate initialized(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                             const LandmarkObservation& z);

}  // namespace slam::particle_filter
