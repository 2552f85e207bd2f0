// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam::ekf {

/// One linearised observation of a landmark in the map: nu = z - h(x), its noise R and the blocks
/// of its sparse Jacobian H.
struct Innovation {
  Eigen::Index slot = 0;  ///< of the landmark among those of the neighbourhood
  Eigen::Vector2d nu = Eigen::Vector2d::Zero();
  Eigen::Matrix2d R = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 2, 3> H_robot = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Vector2d H_heading = Eigen::Vector2d::Zero();  ///< by the heading of the reference pose
  Eigen::Matrix2d H_landmark = Eigen::Matrix2d::Zero();
};

}  // namespace slam::ekf
