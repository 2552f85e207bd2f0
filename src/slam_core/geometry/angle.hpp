// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace slam {

/// The same angle in (-pi, pi] [rad].
inline double wrapAngle(double angle) {
  if (angle > -M_PI && angle <= M_PI) return angle;
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

}  // namespace slam
