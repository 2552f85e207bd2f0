// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam {

/// What a back-end offers that does not estimate how wrong its pose is. The covariance that it
/// reports is that of the odometry, for those who compute with it inside: jumps are told from
/// motion by it. It goes out as zeros, which says "unknown" in ROS (sensor_msgs), and no figure
/// comes of it.
class WithoutCovariance {
 public:
  virtual ~WithoutCovariance() = default;
};

}  // namespace slam
