// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/product/product_components.hpp"

namespace slam {

/// Creates a stage, not configured, for each input whose data none of the components makes, if one
/// is registered that does; likewise for the inputs of these stages. @return makers before takers
std::vector<ProductStage> placeStages(const std::vector<ProductComponent>& components);

}  // namespace slam
