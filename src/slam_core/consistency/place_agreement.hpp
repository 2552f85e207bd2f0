// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Whether a lost robot has been found: three images in a row or more, over 0.2 m or 0.15 rad, have
/// to show the places that odometry leads to from the first one's. Images from one pose show the
/// same, right or wrong, however many they are.
class PlaceAgreement {
 public:
  void move(const Motion& motion) { way_ = way_ * motion.increment; }
  /// @param place where an image has the robot, T_map_base
  /// @return whether this place and those before agree
  bool add(const Pose2& place);
  void clear() { *this = PlaceAgreement(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(first_, way_, in_a_row_);
  }

 private:
  std::optional<Pose2> first_;  ///< the place of the first image in the row
  Pose2 way_;                   ///< of odometry since then
  int in_a_row_ = 0;
};

}  // namespace slam
