// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_sim/world.hpp"

namespace slam::sim {

/// Reads and checks a world file (its form stands in the package's README).
/// @throw ConfigError all that is wrong with it, a sentence each, with file and line: unknown keys
/// and names with the nearest right one, wrong types, values out of range, markers or a path inside
/// walls and furniture, the same id twice, a world with nothing in it
World readWorldFile(const std::string& path);

/// What readWorldFile() checks beyond each value by itself; for worlds made by programs.
/// @throw ConfigError
void checkWorld(const World& world);

}  // namespace slam::sim
