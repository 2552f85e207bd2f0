// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/point_map/point_set.hpp"

namespace slam::point_map {

/// The points as PCD 0.7 (ASCII): x, y, z [m] in the map frame, z = 0, and as intensity how many
/// end points each one is the mean of.
std::string toPcd(const std::vector<MapPoint>& points);

/// Written whole or not at all. @throw std::runtime_error naming the file and the cause
void savePcd(const std::string& path, const std::vector<MapPoint>& points);

}  // namespace slam::point_map
