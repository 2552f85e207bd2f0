// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"

namespace slam_toy {

/// Distances to radio beacons: a kind of data that the product line does not know.
struct BeaconRanges {
  std::uint64_t sequence = 0;
  slam::Stamp stamp;
  std::vector<std::uint32_t> ids;
  std::vector<double> ranges;  ///< one for each id [m]
  double sigma = 0.0;          ///< standard deviation of each range [m]
};

/// Empty, or one sentence on what makes the ranges unusable.
std::string faultOf(const BeaconRanges& seen);

}  // namespace slam_toy
