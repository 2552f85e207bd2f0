// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmark_filter.hpp"
#include "slam_core/particle_filter/proposal.hpp"

namespace slam::particle_filter {

PoseGaussian MotionProposal::propose(const ObservationModel& model, const Sight& sight,
                                     const ParticleMap& map, const PoseGaussian& prior,
                                     RandomStream& random, Prediction* predictions) const {
  const Pose2 pose = prior.sample(random);
  map.prefetch(sight.matches);
  for (const auto& [slot, z] : sight.matches) {
    const auto& landmark = map[slot];
    const auto e = expect(model, pose, sight.sensor, landmark, z);
    *predictions = e ? predictionOf(e->nu, e->R, sight.gate) : singularPrediction(z, sight.gate);
    predictions++->established = landmark.isEstablished();
  }
  return {pose};
}

}  // namespace slam::particle_filter
