// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

/// What one step of the back-end led to, all that is published and written of it.
struct StepReport {
  Stamp stamp;
  /// The input that the step came from; empty: motion had piled up with nothing to see.
  std::string trigger;
  PoseEstimate pose;    ///< in the map frame
  Pose2 odometry_pose;  ///< T_odom_base at the same stamp; of a product without motion the identity
  std::string odometry_frame, base_frame;
  bool has_motion = true;       ///< else nobody knows where the odometry has the robot
  UpdateStatistics statistics;  ///< of back-ends that map landmarks
  std::optional<bool> is_lost;  ///< of back-ends that test it
  bool restarted = false;       ///< time began anew with this step

  bool hasTrigger() const { return !trigger.empty(); }
};

}  // namespace slam
