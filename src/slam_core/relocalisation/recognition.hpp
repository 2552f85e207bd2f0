// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

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

}  // namespace slam::relocalisation
