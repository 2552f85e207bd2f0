// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

// The bare detectors, to read what was rendered.

namespace slam::sim {

struct ReadMarker {
  std::int64_t id;
  std::array<Eigen::Vector2d, 4>
      corners;  ///< upper left, then clockwise [px]; as the library has them
};

/// What the library of the marker's family finds in an image.
std::vector<ReadMarker> readMarkers(const cv::Mat& gray, const std::string& family);

}  // namespace slam::sim
