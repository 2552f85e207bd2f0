// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/random.hpp"

namespace slam::sim {

/// Three independent values of mean 0 and standard deviation 1, drawn in the order x, y, z.
inline Eigen::Vector3d gaussianVector(RandomStream& random) {
  const double x = random.gaussian(), y = random.gaussian(), z = random.gaussian();
  return {x, y, z};
}

}  // namespace slam::sim
