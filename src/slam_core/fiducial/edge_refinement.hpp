// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>

#include "slam_core/fiducial/square_pose.hpp"

namespace slam::fiducial {

/// What is inside of a square's edges and what outside.
enum class Contrast { kBlackOnWhite, kWhiteOnBlack };

/// Moves the corners of a square in the image to where lines through its edges cross (the idea of
/// Wang and Olson 2016): each line is fitted to the places of the steepest slope,
/// looked for across the edge all along it. The corners of a small marker are blurred, its edges
/// are long. Corners stay where edges are not found, or where one would move by more than
/// `max_move` [px]: that is how far off they may be.
void refineByEdges(const cv::Mat& gray, Corners& corners, double max_move,
                   Contrast contrast = Contrast::kBlackOnWhite);

}  // namespace slam::fiducial
