// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/contract/feature_mapper.hpp"

namespace slam {

/// Features as a table, "id,x,y,z,sigma_x,sigma_y,sigma_z", map frame [m]: a line for each.
std::string featureTable(const std::vector<MappedFeature>& features);

}  // namespace slam
