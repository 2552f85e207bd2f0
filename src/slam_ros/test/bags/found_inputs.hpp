// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_ros/bag_inputs.hpp"

namespace slam_ros::test {

using Topics = std::vector<std::string>;

/// The inputs of a product in a bag; the product is the EKF on wheels unless it says otherwise.
inline BagInputs findInputs(const BagReader& bag, const slam::ProductConfig& product = {},
                            const std::vector<Remap>& remaps = {}) {
  return BagInputs(bag, slam::createComponents(product), BagContext(), remaps);
}

/// Sinks that call `take` with each value of a kind.
template <class Data, class Take>
BagSinks sinksFor(Take take) {
  BagSinks sinks;
  sinks.put = [take](const slam::Datum& value, slam::Stamp) {
    if (const auto* data = value.as<Data>()) take(*data);
  };
  return sinks;
}

}  // namespace slam_ros::test
