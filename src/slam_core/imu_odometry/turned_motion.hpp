// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/gyro/gyro_track.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::imu_odometry {

/// The wheels' way along the gyro's heading, instead of their own (Borenstein and Feng 1996,
/// "Gyrodometry"; Chung, Ojeda, Borenstein 2001): the wheels' body velocity is taken to be constant
/// over the motion, and turns with each piece of the gyro's turn. The covariance is complete: what
/// the wheels say of their way, and the heading's error, which swings the way.
/// @param bias of the gyro [rad/s] @param variance of the turn's angle [rad^2]
Motion turnedMotion(const Motion& wheels, const gyro::GyroTurn& turn, double bias, double variance);

}  // namespace slam::imu_odometry
