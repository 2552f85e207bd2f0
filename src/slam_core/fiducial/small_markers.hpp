// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/fiducial/square_pose.hpp"

namespace slam::fiducial {

/// Cells from edge to edge of a marker's black square, of most families; others have fewer, which
/// makes their cells larger.
constexpr double kCells = 8.0;

/// By what share of itself a marker's image may be too large or too small, as a standard deviation.
/// Neighbouring cells blur into the edges of a small one and shift all four alike.
double sizeSigma(const Corners& corners);

}  // namespace slam::fiducial
