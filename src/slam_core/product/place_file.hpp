// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/contract/place_reporter.hpp"

namespace slam {

/// Visits of places as a table, "stamp,first_visit": when each step was taken, and when the robot
/// was first where it took itself to be; empty where it recognised nothing.
std::string placeTable(const std::vector<PlaceVisit>& visits);

}  // namespace slam
