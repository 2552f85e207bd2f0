// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slam_core/contract/event_reporter.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/view_reporter.hpp"
#include "slam_core/models/trust.hpp"

namespace slam {

/// A correction is how far a step moved the pose beyond what odometry says.
struct Correction {
  double distance = 0.0;  ///< [m]
  double turn = 0.0;      ///< [rad], not negative

  template <class Archive>
  void persist(Archive& archive) {
    archive(distance, turn);
  }
};

/// What one step of the back-end led to, all that is published and written of it.
struct StepReport {
  Stamp stamp;
  /// The input that the step came from; empty: motion had piled up with nothing to see.
  std::string trigger;
  PoseEstimate pose;    ///< in the map frame
  Pose2 odometry_pose;  ///< T_odom_base at the same stamp; of a product without motion the identity
  std::string odometry_frame, base_frame;
  bool has_motion = true;              ///< else nobody knows where the odometry has the robot
  UpdateStatistics statistics;         ///< of back-ends that map landmarks
  std::optional<ViewStatistics> view;  ///< of back-ends that follow features through images
  Trust trust = Trust::kConfident;
  std::string doubt;          ///< a clause on why the pose is in doubt; else empty
  bool restarted = false;     ///< time started over with this step
  bool is_relocated = false;  ///< the robot was put somewhere or a map loaded since the last step
  std::vector<Event> events;  ///< what others should know of it, in order
  /// There is none at the first step, and in a product without motion.
  std::optional<Correction> correction;

  bool hasTrigger() const { return !trigger.empty(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, trigger, pose, odometry_pose, odometry_frame, base_frame, has_motion, statistics,
            view, trust, doubt, restarted, is_relocated, events, correction);
  }
};

}  // namespace slam
