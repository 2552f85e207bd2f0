// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"
#include "slam_core/particle_filter/landmarks/proposal.hpp"

// Symbols: mu, P the proposal's mean and covariance, H the Jacobian of an observation in the pose,
// nu innovation with covariance S, R its part that is not the pose's, K gain.

namespace slam::particle_filter {

namespace {

/// Heading of a prior from which on its observations are no plane any more [rad].
constexpr double kWideHeading = 0.15;
constexpr int kMostPasses = 10;

bool isWide(const PoseGaussian& prior) {
  return prior.covariance(2, 2) > kWideHeading * kWideHeading;
}

/// Whether a pose is where another pass has put it, but for a thousandth of its sigma.
bool isSettled(const Pose2& before, const PoseGaussian& after) {
  const Eigen::Vector3d d = difference(after.mean, before);
  return d.dot(after.covariance.ldlt().solve(d)) < 1e-6;
}

/// One pass over all observations.
/// @param point of linearisation; none: wherever the observations before have put the pose
PoseGaussian refined(const ObservationModel& model, const Sight& sight, const ParticleMap& map,
                     const PoseGaussian& prior, const std::optional<Pose2>& point,
                     Prediction* predictions) {
  PoseGaussian refined = prior;
  auto& [mu, P] = refined;
  for (const auto& [slot, column, z] : sight.matches) {
    auto& prediction = predictions[column];
    const auto& landmark = map[slot];
    const Pose2 at = point.value_or(mu);
    const auto e = expect(model, at, sight.sensor, landmark, z);
    if (!e) {
      prediction = singularPrediction(z, sight.gate);
      prediction.established = landmark.isEstablished();
      continue;
    }
    const auto& H = e->H_robot;
    const Eigen::Vector2d nu = e->nu - H * difference(mu, at);
    const Eigen::Matrix<double, 3, 2> P_Ht = P * H.transpose();
    prediction = predictionOf(nu, H * P_Ht + e->R, sight.gate);
    prediction.established = landmark.isEstablished();
    if (!std::isfinite(prediction.log_likelihood * prediction.excess)) continue;
    // an outlier pulls the less the further out it lies (iteratively reweighted least squares), so
    // that a pose that has gone astray finds back
    const Eigen::Matrix2d S = prediction.excess * prediction.S;
    const Eigen::Matrix2d R = e->R + (prediction.excess - 1.0) * prediction.S;
    const Eigen::Matrix<double, 3, 2> K = P_Ht * S.inverse();
    const Eigen::Matrix3d I_KH = Eigen::Matrix3d::Identity() - K * H;
    mu = Pose2::fromVector(mu.vector() + K * nu);
    P = (I_KH * P * I_KH.transpose() + K * R * K.transpose()).eval();
  }
  return refined;
}

}  // namespace

PoseGaussian ConditionedProposal::propose(const ObservationModel& model, const Sight& sight,
                                          const ParticleMap& map, const PoseGaussian& prior,
                                          RandomStream&, Prediction* predictions) const {
  map.prefetch(sight.matches);
  auto proposal = refined(model, sight, map, prior, std::nullopt, predictions);
  if (!isWide(prior)) return proposal;
  for (int pass = 1; pass < kMostPasses; ++pass) {
    const Pose2 before = proposal.mean;
    proposal = refined(model, sight, map, prior, before, predictions);
    if (isSettled(before, proposal)) break;
  }
  return proposal;
}

}  // namespace slam::particle_filter
