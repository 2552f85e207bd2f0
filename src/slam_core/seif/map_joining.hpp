// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "slam_core/graph/local_map.hpp"

namespace slam::seif {

/// The number of a landmark in two local maps: its place in the first one, and in the second.
using SharedPoints = std::vector<std::pair<std::size_t, std::size_t>>;

/// Whether these points alone say where the base of a local map is relative to them: its heading
/// by a sigma of 0.1 rad, beyond which no linearisation of it would mean anything.
bool determinesBase(const graph::LocalMap& map, const std::vector<std::size_t>& points);

/// Two local maps as one in the first one's frame: poses and points of the first, then those that
/// only the second one has (map joining: Tardos, Neira, Newman, Leonard 2002; by least squares:
/// Huang, Wang, Dissanayake 2008).
/// @return nothing where their shared points do not say how they lie to one another
std::optional<graph::LocalMap> joined(const graph::LocalMap& first, const graph::LocalMap& second,
                                      const SharedPoints& shared);

}  // namespace slam::seif
