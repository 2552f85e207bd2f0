// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/backend.hpp"
#include "slam_core/particle_filter/landmark_index.hpp"
#include "slam_core/particle_filter/step.hpp"

namespace slam::particle_filter {

/// Sorts what was seen by known ids into `step`: landmarks of the map and, where the map is not
/// fixed, new ones. The rest is left out and counted as "unknown_id", "duplicate", "not_in_map".
void associate(const LandmarkObservationArray& array, const LandmarkIndex& index, bool map_is_fixed,
               Step& step, UpdateStatistics& statistics, Counters& counters);

}  // namespace slam::particle_filter
