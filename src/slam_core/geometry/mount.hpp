// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace slam {

/// Empty, or what makes a sensor's pose in the robot's base frame unusable (NaN, a matrix that does
/// not rotate).
std::string faultOfMount(const Eigen::Isometry3d& T_base_sensor);

/// The pose that a robot file gives as [x, y, z, roll, pitch, yaw] [m, rad]; nothing where it is
/// empty.
/// @param field the name it has there @throw ConfigError when it has another number of values
std::optional<Eigen::Isometry3d> mountOf(const std::vector<double>& sensor_pose,
                                         const std::string& field);

}  // namespace slam
