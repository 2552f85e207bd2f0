// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/landmark_detector.hpp"

namespace slam::eval {

/// A fiducial detector as the products have it, for markers 36h11 of 0.16 m.
/// @param overrides "section.key=value"
std::unique_ptr<LandmarkDetector> makeDetector(const std::string& name,
                                               const std::vector<std::string>& overrides);

/// A library's own call by itself, single-threaded, with its own default settings.
class BareDetector {
 public:
  virtual ~BareDetector() = default;
  /// The number of markers found.
  virtual int detect(const cv::Mat& gray) = 0;
};

std::unique_ptr<BareDetector> makeBareAprilTag(double quad_decimate);
std::unique_ptr<BareDetector> makeBareAruco();

}  // namespace slam::eval
