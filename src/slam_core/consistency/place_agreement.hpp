// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Whether a lost robot has been found: several images in a row have to show the places that
/// odometry leads to between them.
class PlaceAgreement {
 public:
  void move(const Motion& motion) {
    if (pose_) pose_ = *pose_ * motion.increment;
  }
  /// @param place where an image has the robot, T_map_base
  /// @return whether this place and those before agree
  bool add(const Pose2& place);
  void clear() { *this = PlaceAgreement(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose_, in_a_row_);
  }

 private:
  std::optional<Pose2> pose_;  ///< where the last place and odometry since then have the robot
  int in_a_row_ = 0;
};

}  // namespace slam
