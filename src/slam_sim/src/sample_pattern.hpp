// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace slam::sim {

/// Places of a pixel's samples in [0, 1)^2, in order of time: each row, each column and each slice
/// of time holds one, and no two are near one another in all three. Always the same for a number.
std::vector<Eigen::Vector2d> samplePattern(int samples);

}  // namespace slam::sim
