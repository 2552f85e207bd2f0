// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/map_update.hpp"

#include "slam_core/particle_filter/landmark_filter.hpp"

namespace slam::particle_filter {

void updateMap(const ObservationModel& model, const Step& step, const Pose2& pose,
               const Prediction* predictions, ParticleMap& map, unsigned lane) {
  if (step.is_doubtful) return;
  const auto& [sensor, matches, gate] = step.sight;
  const bool is_trusted = !step.is_lost && !isDoubtful(predictions, matches.size());
  map.prefetch(matches);
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& [slot, z] = matches[k];
    const bool fits = !predictions[k].gated;
    if (fits || is_trusted) takeSighting(model, pose, sensor, z, fits, map.edit(slot, lane));
  }
  for (const auto& z : step.unseen) map.push_back(initialized(model, pose, sensor, z), lane);
}

}  // namespace slam::particle_filter
