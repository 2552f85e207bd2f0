// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "slam_core/models/landmark_map.hpp"

namespace slam::particle_filter {

/// The poses' indices along a Hilbert curve through the ellipsoid of their covariance: neighbours
/// in this order are neighbours in space. Resampling in it keeps the spread of the poses better
/// than in any other (Gerber, Chopin, Whiteley 2019), which counts where the weights say nothing of
/// it.
std::vector<std::uint32_t> hilbertOrder(const std::vector<Pose2>& poses,
                                        const PoseEstimate& estimate);

/// The position along the three-dimensional Hilbert curve of a cell with the given coordinates,
/// each below 2^bits (Skilling 2004).
std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y, std::uint32_t z, unsigned bits);

}  // namespace slam::particle_filter
