// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "beacon_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace slam_toy {
namespace {

bool isRange(double range) { return std::isfinite(range) && range > 0.0; }

}  // namespace

std::string faultOf(const BeaconRanges& seen) {
  if (seen.ids.size() != seen.ranges.size())
    return "a message of beacons has " + std::to_string(seen.ids.size()) + " ids and " +
           std::to_string(seen.ranges.size()) + " ranges; send one range for each id";
  if (!std::all_of(seen.ranges.begin(), seen.ranges.end(), isRange))
    return "a message of beacons has a range that is not a number above 0; leave out beacons that "
           "were not heard";
  if (!isRange(seen.sigma))
    return "a message of beacons has a sigma that is not a number above 0; send the ranges' "
           "standard deviation";
  return "";
}

}  // namespace slam_toy
