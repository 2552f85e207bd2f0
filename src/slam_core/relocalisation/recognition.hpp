// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/models/landmark_map.hpp"

namespace slam::relocalisation {

/// What a search for the robot has found.
struct Recognition {
  enum class Verdict {
    kNothing,    ///< no place explains what is seen
    kAmbiguous,  ///< several do
    kLikely,     ///< one does, which has yet to be confirmed
    kConfirmed
  };
  Verdict verdict = Verdict::kNothing;
  PoseEstimate robot;  ///< where it is likely or confirmed

  bool hasPlace() const { return verdict == Verdict::kLikely || verdict == Verdict::kConfirmed; }
};

}  // namespace slam::relocalisation
