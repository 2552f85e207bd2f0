// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// T_map_base at a time.
struct StampedPose {
  Stamp stamp;
  Pose2 pose;

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, pose);
  }
};

}  // namespace slam
