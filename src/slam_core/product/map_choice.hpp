// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/backend.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// Has the back-end make the product's map, from its next configure() on.
/// @throw ConfigError where it cannot, with the reason and the nearest products that make sense
void chooseMap(const ProductConfig& product, Backend& backend);

}  // namespace slam
