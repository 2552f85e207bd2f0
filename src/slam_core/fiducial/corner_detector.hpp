// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/common/settings.hpp"
#include "slam_core/fiducial/marker_detection.hpp"

namespace slam::fiducial {

/// The policy that finds markers in an image: their ids and corners (Olson 2011; Garrido-Jurado et
/// al. 2014). One thread at a time.
class CornerDetector {
 public:
  virtual ~CornerDetector() = default;

  /// Reads its own section. @throw ConfigError listing all faults
  virtual void configure(Settings& settings) = 0;
  /// Appends what is in the image (8 bit gray) to `found`; rejects what it read with doubt.
  virtual void detect(const cv::Mat& gray, std::vector<MarkerDetection>& found) = 0;
};

}  // namespace slam::fiducial
