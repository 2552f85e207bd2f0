// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "pose_graph.hpp"

namespace slam::eval {

/// How false loops lie to one another, as in the experiments of Suenderhauf, Protzel 2012.
enum class FalseLoopKind {
  kRandom,        ///< between any two poses
  kLocal,         ///< between poses at most 20 steps apart
  kRandomGroups,  ///< 20 loops between two pieces of the way, which agree with one another
  kLocalGroups    ///< the same, between pieces at most 20 steps apart
};

/// Adds false loops to a graph, as vertigo's script does: each says that one pose is where another
/// one is, to some decimetres and degrees, with the information matrix of the first true loop. A
/// loop that is true by chance, within the bounds of its noise, is drawn anew. The graph's truth
/// decides what is true, dead reckoning where there is no truth.
/// @throw std::runtime_error where the graph is too small for that
void addFalseLoops(PoseGraph& graph, FalseLoopKind kind, int count, std::uint64_t seed);

}  // namespace slam::eval
