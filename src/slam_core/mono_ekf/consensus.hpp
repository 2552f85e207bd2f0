// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/mono_ekf/mono_state.hpp"

namespace slam::mono_ekf {

/// A feature that was found in the image.
struct Match {
  std::size_t feature = 0;  ///< which one of the state's
  Eigen::Vector2d pixel;
};

/// The matches that agree with each other.
struct Consensus {
  std::vector<bool> agrees;  ///< of each match
  /// They are the matches that agree, and update the state these were judged by. They are
  /// linearised at the state after an update with most of them (a step of the iterated EKF).
  std::vector<Measurement> measurements;
};

/// The matches that agree on where the robot and they themselves are, by 1-point RANSAC (Civera,
/// Grasa, Davison and Montiel 2010). Each match in turn updates the state; the hypothesis that most
/// others agree with within the pixel noise gives the first inliers. They update the state, and
/// those that fit it then join them. All hypotheses are tried: there is no chance in it.
/// @param sigma of a pixel's coordinate [px]
Consensus consensusOf(const MonoState& state, const std::vector<Match>& matches,
                      const PlanarCamera& camera, double sigma);

}  // namespace slam::mono_ekf
