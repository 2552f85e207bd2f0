// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam::eval {

/// Reads the true poses of a graph: rows `x y theta` in the order of rising ids, or rows
/// `id x y theta` in any order. Poses that the graph has not are ignored in the second form.
/// @param ids of the graph's poses
/// @return a pose for each of the ids, in their order
/// @throw ImportError where a row is wrong or a pose is missing
std::vector<Pose2> readGraphTruth(const std::string& path, const std::vector<std::int64_t>& ids);

}  // namespace slam::eval
