// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/proposal.hpp"

#include <Eigen/LU>
#include <cmath>

#include "slam_core/common/policy_table.hpp"
#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"

namespace slam::particle_filter {

Prediction predictionOf(const Eigen::Vector2d& nu, const Eigen::Matrix2d& S, double gate) {
  const double determinant = S.determinant();
  const double distance =
      (S(1, 1) * nu.x() * nu.x() - 2.0 * S(0, 1) * nu.x() * nu.y() + S(0, 0) * nu.y() * nu.y()) /
      determinant;
  Prediction prediction;
  prediction.nu = nu;
  prediction.S = S;
  prediction.gated = !(distance <= gate);  // also where it is no number
  prediction.excess = prediction.gated ? distance / gate : 1.0;
  const double exponent = prediction.gated ? gate * (1.0 + std::log(prediction.excess)) : distance;
  prediction.log_likelihood = -0.5 * exponent - 0.5 * std::log(determinant) - std::log(2.0 * M_PI);
  prediction.gated |= !std::isfinite(prediction.log_likelihood);
  return prediction;
}

Prediction singularPrediction(const LandmarkObservation& z, double gate) {
  Prediction prediction;
  prediction.nu = z.vector();
  prediction.S = z.covariance;
  prediction.gated = true;
  prediction.log_likelihood =
      -0.5 * gate - 0.5 * std::log(z.covariance.determinant()) - std::log(2.0 * M_PI);
  return prediction;
}

Prediction unmatchedPrediction(const LandmarkObservation& z, double gate) {
  auto prediction = singularPrediction(z, gate);
  prediction.matched = false;
  return prediction;
}

bool isDoubtful(const Prediction* predictions, std::size_t count) {
  std::size_t established = 0, gated = 0;
  for (std::size_t k = 0; k < count; ++k) {
    established += predictions[k].established;
    gated += predictions[k].established && predictions[k].gated;
  }
  return 2 * gated > established;
}

PoseGaussian MotionProposal::propose(const ObservationModel& model, const Sight& sight,
                                     const ParticleMap& map, const PoseGaussian& prior,
                                     RandomStream& random, Prediction* predictions) const {
  const Pose2 pose = prior.sample(random);
  map.prefetch(sight.matches);
  for (const auto& [slot, column, z] : sight.matches) {
    const auto& landmark = map[slot];
    const auto e = expect(model, pose, sight.sensor, landmark, z);
    auto& prediction = predictions[column];
    prediction = e ? predictionOf(e->nu, e->R, sight.gate) : singularPrediction(z, sight.gate);
    prediction.established = landmark.isEstablished();
  }
  return {pose};
}

namespace {

const PolicyTable<Proposal>& proposalTable() {
  static const PolicyTable<Proposal> kTable(
      {{"fastslam1", makePolicyOf<Proposal, MotionProposal>},
       {"fastslam2", makePolicyOf<Proposal, ConditionedProposal>}});
  return kTable;
}

}  // namespace

const std::vector<std::string>& proposalNames() { return proposalTable().names(); }

std::unique_ptr<Proposal> makeProposal(const std::string& name) {
  return proposalTable().make(name);
}

}  // namespace slam::particle_filter
