// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/time.hpp"

namespace slam {

/// The velocity that the robot's base is to have from this stamp on.
struct VelocityCommand {
  Stamp stamp;
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();  ///< vx, vy, omega in base [m/s, m/s, rad/s]

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, twist);
  }
};

}  // namespace slam
