// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace slam {

/// The Jacobian of the coordinates (x, y, theta) of Pose2::exp(twist) in the twist.
Eigen::Matrix3d arcJacobian(const Eigen::Vector3d& twist);

}  // namespace slam
