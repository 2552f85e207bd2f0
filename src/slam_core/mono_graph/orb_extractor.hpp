// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/mono_graph/features.hpp"

namespace slam::mono_graph {

/// The pyramid of ORB (Rublee et al. 2011): each level is so much smaller than the one before.
constexpr double kPyramidScale = 1.2;
constexpr int kPyramidLevels = 6;

/// Features with descriptors, spread over an image: the strongest ones of each of its cells
/// (Mur-Artal et al. 2015, V.A). They come in an order that depends on the image alone.
class OrbExtractor {
 public:
  OrbExtractor() = default;
  /// @param count how many an image gives at most @param sigma of one of the finest level [px]
  OrbExtractor(int count, double sigma) : count_(count), sigma_(sigma) {}

  /// @pre view.isUsable(), gray levels of 8 bit
  Features extract(const CameraView& view) const;
  /// The keypoints and their descriptors, one a row; for an image without calibration.
  std::vector<cv::KeyPoint> describe(const cv::Mat& gray, std::vector<Descriptor>& found) const;

 private:
  int count_ = 0;
  double sigma_ = 0.0;
};

}  // namespace slam::mono_graph
