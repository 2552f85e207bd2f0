// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/grid_map/grid_map.hpp"

namespace slam::grid_map {

/// An occupied cell raises the likelihood around the mean of its ends.
void giveLikelihood(const BeamModel& model, CellIndex cell, GridMap& map);

/// A cell is no longer occupied: the likelihood around it is what the others give.
void takeLikelihood(const BeamModel& model, CellIndex cell, GridMap& map);

}  // namespace slam::grid_map
