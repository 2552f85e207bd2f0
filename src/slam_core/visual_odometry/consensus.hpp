// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/random.hpp"
#include "slam_core/visual_odometry/point_match.hpp"
#include "slam_core/visual_odometry/rigid_fit.hpp"

namespace slam::visual_odometry {

/// Finds the similarity that most matches agree with (RANSAC; Fischler and Bolles 1981) from pairs
/// of matches drawn by `random`; the same numbers give the same result.
/// @param threshold largest residual of a match that agrees [its sigma]
/// @return the agreeing matches; nothing when there are fewer than two matches
std::optional<PointMatches> findConsensus(const PointMatches& matches, double threshold,
                                          RandomStream& random);

/// The matches that agree with a rigid motion.
PointMatches agreeing(const PointMatches& matches, const Similarity& motion, double threshold);

}  // namespace slam::visual_odometry
