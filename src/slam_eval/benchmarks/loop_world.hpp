// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::eval {

/// The consistency case: a robot drives a circle several times among point landmarks, in the plane
/// of Huang, Mourikis, Roumeliotis 2010. Motion and sensor noise are exactly what the filter is
/// told, so that an honest filter has a mean NEES of 3 and a mean NIS of 1 per degree of freedom.
struct LoopWorldConfig {
  double loop_length = 60.0;  ///< [m]
  int laps = 3;
  int landmarks = 20;
  double landmark_band = 4.0;    ///< landmarks lie this near the way [m]
  double view_range = 5.0;       ///< [m], all around
  double sigma_range = 0.1;      ///< [m]
  double sigma_bearing = 0.02;   ///< [rad]
  double step_length = 0.25;     ///< way between two observations [m]
  double sigma_position = 0.02;  ///< of a step, along and across [m]
  double sigma_heading = 0.01;   ///< of a step [rad]
};

/// What happens in one step: the motion measured, the observations, the true pose in the frame of
/// the first one.
struct LoopStep {
  slam::Motion motion;
  slam::LandmarkObservationArray observations;
  slam::Pose2 truth;
};

/// The world of one seed; landmarks and noise depend on it.
std::vector<LoopStep> simulateLoop(const LoopWorldConfig& config, std::uint64_t seed);

}  // namespace slam::eval
