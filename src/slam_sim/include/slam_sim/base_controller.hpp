// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/random.hpp"
#include "slam_sim/robot_model.hpp"
#include "slam_sim/sensors.hpp"

namespace slam::sim {

/// The command at the path's second 0, which holds until the next one and has moved the base along
/// the path: with a lag of first order, a scale and white noise between the two.
/// @return (vx, vy, omega) in the base [m/s, m/s, rad/s]
Eigen::Vector3d commandFor(const BasePath& T_world_base, const CommandModel& model,
                           RandomStream& random);

}  // namespace slam::sim
