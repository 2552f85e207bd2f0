// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// A turn of the robot about the vertical, as a sensor measured it.
struct Turn {
  double angle = 0.0;     ///< [rad]
  double variance = 0.0;  ///< [rad^2]
};

/// Gives the turn between two stamps as another sensor measured it; nothing where it cannot be
/// used.
using TurnSource = std::function<std::optional<Turn>(Stamp start, Stamp end)>;

}  // namespace slam
