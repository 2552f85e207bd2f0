// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Whether a lost robot has been found: several images in a row, each 0.2 m or 0.15 rad after the
/// one before, have to show the places that odometry leads to between them. An image from nearer
/// shows the same once more, right or wrong, and does not count.
class PlaceAgreement {
 public:
  void move(const Motion& motion) { way_ = way_ * motion.increment; }
  /// @param place where an image has the robot, T_map_base
  /// @return whether this place and those before agree
  bool add(const Pose2& place);
  void clear() { *this = PlaceAgreement(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(place_, way_, in_a_row_);
  }

 private:
  std::optional<Pose2> place_;  ///< of the last image that counted
  Pose2 way_;                   ///< of odometry since then
  int in_a_row_ = 0;
};

}  // namespace slam
