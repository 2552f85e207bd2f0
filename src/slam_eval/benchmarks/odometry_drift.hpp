// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "slam_core/models/motion.hpp"

namespace slam::eval {

/// An odometry's way beside the true one, pose by pose.
struct OdometryTrack {
  std::vector<Pose2> truth, odometry;
  std::vector<Motion>
      motions;  ///< from each pose to the next; empty where covariances do not count
};

/// Errors over all pieces of the true way that are `length` [m] long, relative to it: translation
/// [1] and rotation [rad/m]; and over all pieces that turn by `angle` [rad] on the spot, relative
/// to the angle. A key without a piece is absent.
nlohmann::json driftOf(const OdometryTrack& track, double length = 2.0, double angle = 1.5708);

/// Normalised error squared of increments over `steps` motions, mean over three degrees of freedom:
/// 1 when the covariances are right, less when they are too large.
double normalisedError(const OdometryTrack& track, std::size_t steps);

}  // namespace slam::eval
