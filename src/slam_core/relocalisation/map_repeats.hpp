// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/association/constellation_search.hpp"

namespace slam::relocalisation {

/// Finds the motions, in the map frame, that bring a part of a map onto another part that looks the
/// same, as the tiles of a ceiling do. Where a map repeats itself, the world beyond it may do so as
/// well: a place that is the only one of its look in the map need not be the only one there is.
/// Each motion comes with its inverse. Some parts are looked at, spread evenly over the map.
/// @param at_least log-odds at which a part looks like another one
std::vector<Pose2> repeatsOf(const LandmarkMap& map, const association::ConstellationSearch& search,
                             double at_least);

}  // namespace slam::relocalisation
