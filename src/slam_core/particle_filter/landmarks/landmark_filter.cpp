// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace slam::particle_filter {

std::optional<Expectation> expect(const ObservationModel& model, const Pose2& robot,
                                  const Pose2& sensor, const LandmarkEstimate& landmark,
                                  const LandmarkObservation& z) {
  Expectation e;
  const Eigen::Vector2d z_predicted =
      model.predict(robot, sensor, landmark.mean(), &e.H_robot, &e.H_landmark);
  if (model.isSingular(z_predicted)) return std::nullopt;
  e.nu = model.innovation(z.vector(), z_predicted);
  e.R = e.H_landmark * landmark.covariance() * e.H_landmark.transpose() + z.covariance;
  return e;
}

LandmarkEstimate updated(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                         const LandmarkEstimate& landmark, const LandmarkObservation& z) {
  const auto e = expect(model, robot, sensor, landmark, z);
  if (!e) return landmark;
  const Eigen::Matrix2d P = landmark.covariance();
  const Eigen::Matrix2d K = P * e->H_landmark.transpose() * e->R.inverse();
  const Eigen::Matrix2d I_KH = Eigen::Matrix2d::Identity() - K * e->H_landmark;
  LandmarkEstimate after(landmark.mean() + K * e->nu,
                         I_KH * P * I_KH.transpose() + K * z.covariance * K.transpose());
  after.credit = landmark.credit;
  after.number = landmark.number;
  return after;
}

void takeSighting(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                  const LandmarkObservation& z, bool fits, LandmarkEstimate& landmark) {
  if (fits) {
    landmark = updated(model, robot, sensor, landmark, z);
    landmark.credit = std::min(landmark.credit + 1, LandmarkEstimate::kMostCredit);
  } else if (--landmark.credit < 0) {
    const auto number = landmark.number;
    landmark = initialized(model, robot, sensor, z);
    landmark.number = number;
  }
}

LandmarkEstimate initialized(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                             const LandmarkObservation& z) {
  Eigen::Matrix2d J_m_z;
  const Eigen::Vector2d m = model.invert(robot, sensor, z.vector(), nullptr, &J_m_z);
  return {m, J_m_z * z.covariance * J_m_z.transpose()};
}

}  // namespace slam::particle_filter
