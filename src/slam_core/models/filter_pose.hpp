// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// A pose of the filter's as it is published: the heading as the z and w of a unit quaternion, so
/// that one that went through a message has the same bits as one that did not.
struct FilterPose {
  Stamp stamp;
  double x = 0.0, y = 0.0;    ///< of the robot in the map frame [m]
  double qz = 0.0, qw = 1.0;  ///< sine and cosine of half the heading

  static FilterPose of(Stamp stamp, const Pose2& T_map_base);
  Pose2 pose() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, x, y, qz, qw);
  }
};

}  // namespace slam
