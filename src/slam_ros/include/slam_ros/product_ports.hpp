// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json.hpp>

#include "slam_core/product/product_config.hpp"

namespace slam_ros {

/// The inputs and outputs of a product, from the ports and capabilities of its components:
/// "components" in the order of the data's flow, "gates" that the wiring places before them, and
/// "owns_odometry_edge". Topics have their default names, which a robot file may change.
/// @throw slam::ConfigError
nlohmann::ordered_json describePorts(const slam::ProductConfig& product);

/// The names of all registered components by the product's key of their role; those of additional
/// modules, each of which is a key of its own, by "modules".
nlohmann::ordered_json describeComponents();

/// Refuses a product whose components cannot be wired: two make the same output, some take data
/// from one another in a circle, or one needs data that no component makes and no topic brings.
/// @throw slam::ConfigError listing all faults
void checkPorts(const slam::ProductConfig& product);

}  // namespace slam_ros
