// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/models/landmark_map.hpp"

namespace slam::graph_slam {

/// What an estimate of a motion says beyond another one that it has used.
/// @param P covariance of the estimate @param used that of the other one, both positive definite
/// @return an information matrix; where nothing is left of it, a trace that keeps it positive
/// definite
Eigen::Matrix3d informationBeyond(const Eigen::Matrix3d& P, const Eigen::Matrix3d& used);

/// Whether two estimates of one motion are so far apart that one of them must be wrong: 0.999 of
/// the chi-square distribution. The covariances are those of (x, y, theta).
bool contradict(const PoseEstimate& a, const PoseEstimate& b);

}  // namespace slam::graph_slam
