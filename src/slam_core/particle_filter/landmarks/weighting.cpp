// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/weighting.hpp"

#include "slam_core/common/policy_table.hpp"
#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"

namespace slam::particle_filter {

double Weighting::logFactor(const Prediction* predictions, std::size_t count) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) sum += predictions[k].log_likelihood;
  return sum;
}

double ImportanceWeighting::logCorrection(const ObservationModel& model, const Sight& sight,
                                          const ParticleMap& map, const PoseGaussian& prior,
                                          const PoseGaussian& proposal, const Pose2& drawn,
                                          const Prediction* predictions) const {
  if (proposal.isCertain() || sight.matches.empty()) return 0.0;  // weighed at the pose itself
  double sum = prior.logDensity(drawn) - proposal.logDensity(drawn);
  for (const auto& [slot, column, z] : sight.matches) {
    if (predictions[column].gated) continue;
    const auto e = expect(model, drawn, sight.sensor, map[slot], z);
    const auto exact =
        e ? predictionOf(e->nu, e->R, sight.gate) : singularPrediction(z, sight.gate);
    sum += exact.log_likelihood - predictions[column].log_likelihood;
  }
  return sum;
}

namespace {

const PolicyTable<Weighting>& weightingTable() {
  static const PolicyTable<Weighting> kTable(
      {{"predictive", makePolicyOf<Weighting, PredictiveWeighting>},
       {"importance", makePolicyOf<Weighting, ImportanceWeighting>}});
  return kTable;
}

}  // namespace

const std::vector<std::string>& weightingNames() { return weightingTable().names(); }

std::unique_ptr<Weighting> makeWeighting(const std::string& name) {
  return weightingTable().make(name);
}

}  // namespace slam::particle_filter
