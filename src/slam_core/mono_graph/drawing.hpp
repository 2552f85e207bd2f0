// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>

#include "slam_core/mono_graph/tracker.hpp"

namespace slam::mono_graph {

/// A copy of an image in colour, with a point for each of its features: green where it is a point
/// of the map, red where it looks like one but does not fit the pose, grey where it is none.
/// @param gray 8 bit, one channel; else the result is empty
cv::Mat draw(const cv::Mat& gray, const Features& features, const TrackedView& tracked);

}  // namespace slam::mono_graph
