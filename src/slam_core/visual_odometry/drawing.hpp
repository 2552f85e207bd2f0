// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>

#include "slam_core/visual_odometry/point_match.hpp"

namespace slam::visual_odometry {

/// The image in colour with a line from where each point was in the reference to where it is now
/// (thesis Fig. 5.6): green where the matches agree on one motion, red where not.
/// @return empty when there is no gray image
cv::Mat draw(const cv::Mat& gray, const PointMatches& matches, const PointMatches& inliers);

}  // namespace slam::visual_odometry
