// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// Finds keypoints and describes what surrounds them.
class KeypointDetector {
 public:
  virtual ~KeypointDetector() = default;
  /// A row of descriptors for each keypoint.
  virtual void detect(const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints,
                      cv::Mat& descriptors) = 0;
  /// How coarse a keypoint was found, relative to the finest ones: its place is that uncertain.
  virtual double coarseness(const cv::KeyPoint& keypoint) const = 0;
  /// Descriptors of the same point differ by less: bits, or the distance of vectors.
  virtual double maxDistance() const = 0;
  /// As FeaturePolicy::dependence().
  virtual double dependence() const = 0;
};

/// @param kind of features that have descriptors: all but KLT
/// @throw ConfigError when the installed OpenCV does not have it, with the nearest
std::unique_ptr<KeypointDetector> makeKeypointDetector(FeatureKind kind, int max_features);

}  // namespace slam::visual_odometry
