// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam::graph_slam {

/// A landmark that two maps have.
struct SharedLandmark {
  std::size_t first = 0, second = 0;  ///< its numbers there
  /// The maps have it there, each in its own frame [m].
  Eigen::Vector2d in_first = Eigen::Vector2d::Zero(), in_second = Eigen::Vector2d::Zero();
  Eigen::Matrix2d first_covariance = Eigen::Matrix2d::Zero();   ///< [m^2]
  Eigen::Matrix2d second_covariance = Eigen::Matrix2d::Zero();  ///< [m^2]
};

/// A meeting says how a second map lies in a first one.
struct LandmarkMeeting {
  Pose2 first_second;                 ///< T_first_second, of the map frames
  std::vector<std::size_t> agreeing;  ///< of the shared landmarks, those that lie where it says
};

/// The rigid motion by which most of the shared landmarks lie in both maps at one place, as far as
/// the covariances tell: consensus over pairs (Fischler and Bolles 1981, with all pairs of some
/// landmarks in place of random ones).
/// @return nothing where fewer than three agree, all within a metre, or no more than contradict
std::optional<LandmarkMeeting> meetingOf(const std::vector<SharedLandmark>& shared);

/// So many of the numbers from 0 on, evenly spaced; all where there are no more.
std::vector<std::size_t> evenlyChosen(std::size_t most, std::size_t size);

}  // namespace slam::graph_slam
