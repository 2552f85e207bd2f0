// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::relocalisation {

/// What a search for the robot has found.
struct Recognition {
  enum class Verdict {
    kNothing,    ///< no place explains what is seen
    kAmbiguous,  ///< several places do
    kLikely,     ///< one place does and has yet to be confirmed
    kConfirmed   ///< one place does, repeatedly
  };
  Verdict verdict = Verdict::kNothing;
  PoseEstimate robot;  ///< set where the verdict is kLikely or kConfirmed

  bool hasPlace() const { return verdict == Verdict::kLikely || verdict == Verdict::kConfirmed; }
};

/// Whether two poses are the same place, within the accuracy of a search.
inline bool areOnePlace(const Pose2& a, const Pose2& b) {
  constexpr double kShift = 0.5, kTurn = 0.3;  // [m], [rad]
  return (a.position() - b.position()).norm() < kShift &&
         std::abs(wrapAngle(a.theta() - b.theta())) < kTurn;
}

}  // namespace slam::relocalisation
