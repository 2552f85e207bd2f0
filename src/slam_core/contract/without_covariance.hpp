// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/capabilities.hpp"

namespace slam {

/// Offered by a back-end that does not estimate the covariance of its pose. The covariance that it
/// reports is that of the odometry, for internal use: with it jumps are distinguished from motion.
/// It is published as zeros, which means "unknown" in ROS (sensor_msgs), and no figure is computed
/// from it. The trust in the pose is Trust::kUnknown.
class WithoutCovariance {
 public:
  virtual ~WithoutCovariance() = default;
};

inline bool isWithoutCovariance(const Capabilities& backend) {
  return backend.find<WithoutCovariance>() != nullptr;
}

}  // namespace slam
