// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <cmath>

#include "slam_core/particle_filter/landmark_filter.hpp"
#include "slam_core/particle_filter/proposal.hpp"

// Symbols: mu, P the proposal's mean and covariance, H the Jacobian of an observation in the pose,
// nu innovation with covariance S, R its part that is not the pose's, K gain.

namespace slam::particle_filter {

PoseGaussian ConditionedProposal::propose(const ObservationModel& model, const Sight& sight,
                                          const ParticleMap& map, const PoseGaussian& prior,
                                          RandomStream&, Prediction* predictions) const {
  PoseGaussian refined = prior;
  auto& [mu, P] = refined;
  map.prefetch(sight.matches);
  for (const auto& [slot, z] : sight.matches) {
    auto& prediction = *predictions++;
    const auto& landmark = map[slot];
    const auto e = expect(model, mu, sight.sensor, landmark, z);
    if (!e) {
      prediction = singularPrediction(z, sight.gate);
      prediction.established = landmark.isEstablished();
      continue;
    }
    const auto& H = e->H_robot;
    const Eigen::Matrix<double, 3, 2> P_Ht = P * H.transpose();
    prediction = predictionOf(e->nu, H * P_Ht + e->R, sight.gate);
    prediction.established = landmark.isEstablished();
    if (!std::isfinite(prediction.log_likelihood * prediction.excess)) continue;
    // an outlier pulls the less the further out it lies (iteratively reweighted least squares), so
    // that a pose that has gone astray finds back
    const Eigen::Matrix2d S = prediction.excess * prediction.S;
    const Eigen::Matrix2d R = e->R + (prediction.excess - 1.0) * prediction.S;
    const Eigen::Matrix<double, 3, 2> K = P_Ht * S.inverse();
    const Eigen::Matrix3d I_KH = Eigen::Matrix3d::Identity() - K * H;
    mu = Pose2::fromVector(mu.vector() + K * e->nu);
    P = (I_KH * P * I_KH.transpose() + K * R * K.transpose()).eval();
  }
  return refined;
}

}  // namespace slam::particle_filter
