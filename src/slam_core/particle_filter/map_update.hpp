// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/particle_filter/particle.hpp"
#include "slam_core/particle_filter/step.hpp"

namespace slam::particle_filter {

/// What a particle saw goes into its map: known landmarks are updated, new ones begun. A landmark
/// that does not fit loses credit only where the particle, or the filter as a whole, can be trusted
/// instead of it. For several threads at once.
/// @param pose of the particle after the step
/// @param predictions of the particle, or its ancestor's
void updateMap(const ObservationModel& model, const Step& step, const Pose2& pose,
               const Prediction* predictions, ParticleMap& map, unsigned lane);

}  // namespace slam::particle_filter
