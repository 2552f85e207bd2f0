// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/models/landmark_map.hpp"

namespace slam {

/// Coordinates in the maps of countries have seven digits; squares of larger ones lose the metre.
constexpr double kFarthestInMap = 1e8;  // [m], of x and y from the map's origin

/// Why a pose that somebody gives cannot be used, as a sentence without its end; empty where it
/// can. Its values have to be finite and no further from the map's origin than kFarthestInMap, its
/// covariance symmetric and positive semidefinite.
std::string faultOf(const PoseEstimate& estimate);

/// The same of a map, of which the sentence names the part: the pose, a landmark, the joint
/// covariance, the grid. Landmarks have to be sorted by id. Standard deviations of landmarks may
/// not exceed kFarthestInMap either.
std::string faultOf(const MapState& map);

}  // namespace slam
