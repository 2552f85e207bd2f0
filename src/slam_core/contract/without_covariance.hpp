// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/capabilities.hpp"

namespace slam {

/// What a back-end offers that does not estimate how wrong its pose is. The covariance that it
/// reports is that of the odometry, for those who compute with it inside: jumps are told from
/// motion by it. It goes out as zeros, which says "unknown" in ROS (sensor_msgs), and no figure
/// comes of it. Nothing can be said of how far the pose can be relied on (Trust::kUnknown).
class WithoutCovariance {
 public:
  virtual ~WithoutCovariance() = default;
};

inline bool isWithoutCovariance(const Capabilities& backend) {
  return backend.find<WithoutCovariance>() != nullptr;
}

}  // namespace slam
