// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/graph_slam/session.hpp"

namespace slam::graph_slam {

/// Empty, or what keeps a session whose values are finite from being used: numbers of what there is
/// not, ids that repeat, weights that are no square roots of information, parts of the graph that
/// nothing ties to the map.
std::string faultOf(const Session& session);

}  // namespace slam::graph_slam
