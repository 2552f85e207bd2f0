// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/small_markers.hpp"

#include <algorithm>

namespace slam::fiducial {

double sizeSigma(const Corners& corners) {
  constexpr double kWideCell = 3.0;  // wider than what an edge spreads over [px]
  constexpr double kShift = 0.15;    // of an edge between cells of half that width [px]
  const double side = meanSide(corners);
  const double narrowness = std::max(0.0, kWideCell * kCells / side - 1.0);
  return 2.0 * kShift * narrowness / side;
}

}  // namespace slam::fiducial
