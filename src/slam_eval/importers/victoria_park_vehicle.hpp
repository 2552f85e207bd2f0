// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The vehicle of the Victoria Park data set, a utility car ("ute") with Ackermann steering. The
/// dimensions are those that its authors give (Guivant, Nebot 2001). The robot's frame is the
/// middle of the rear axle, x ahead.
namespace slam::eval::victoria_park {

constexpr double kWheelBase = 2.83;  // L, between the axles [m]
constexpr double kEncoderOffset =
    0.76;                             // H, of the left rear wheel with the encoder, to the left [m]
constexpr double kLaserAhead = 3.78;  // a, of the laser and of the GPS antenna above it [m]
constexpr double kLaserLeft = 0.50;   // b [m]

}  // namespace slam::eval::victoria_park
