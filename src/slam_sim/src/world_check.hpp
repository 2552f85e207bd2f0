// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {

/// What a world's parts are called in messages: "office.yaml:12: markers[3]".
struct WorldPlaces {
  std::string world, path;
  std::vector<std::string> walls, furniture, markers, doors;
};

WorldPlaces placesOf(const World& world);

/// Whether the parts fit together; each of them is known to be sound by itself.
void checkFit(const World& world, const WorldPlaces& places, FaultCollector& faults);

}  // namespace slam::sim
