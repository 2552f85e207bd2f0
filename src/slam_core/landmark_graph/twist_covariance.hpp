// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/geometry/pose2.hpp"

namespace slam::landmark_graph {

/// The covariance of a pose as a twist in its frame from that of its coordinates (x, y, theta),
/// with a floor of a micrometre and a microradian.
Eigen::Matrix3d twistCovariance(const Pose2& pose, const Eigen::Matrix3d& of_coordinates);
/// The other way.
Eigen::Matrix3d coordinateCovariance(const Pose2& pose, const Eigen::Matrix3d& of_twist);

}  // namespace slam::landmark_graph
