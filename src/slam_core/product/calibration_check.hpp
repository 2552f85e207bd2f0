// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/settings.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// Checks that what `calibration.estimate` lists can be calibrated by the product's back-end, and
/// belongs to what tells its motion; and that what corrects one sensor is not given for two.
/// @throw ConfigError
void checkCalibration(const ProductConfig& product, const Capabilities& backend,
                      Settings& settings);

}  // namespace slam
