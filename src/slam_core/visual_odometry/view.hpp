// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/visual_odometry/features.hpp"

namespace slam::visual_odometry {

/// An image and where the robot was.
struct View {
  Stamp stamp{};
  std::shared_ptr<const Features> features;  ///< none of an image that cannot be used
  Pose2 T_odom_base;

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, features, T_odom_base);
  }
};

}  // namespace slam::visual_odometry
