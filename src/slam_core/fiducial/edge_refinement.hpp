// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>

#include "slam_core/fiducial/square_pose.hpp"

namespace slam::fiducial {

/// Moves the corners of a black square on white, given within a pixel or two, to where lines
/// through its edges cross (the idea of Wang and Olson 2016): each line is fitted to the places of
/// the steepest descent into the black, looked for across the edge all along it. The corners of a
/// small marker are blurred, its edges are long. Corners whose edges are not found stay.
void refineByEdges(const cv::Mat& gray, Corners& corners);

}  // namespace slam::fiducial
