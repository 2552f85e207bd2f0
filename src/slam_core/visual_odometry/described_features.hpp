// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/visual_odometry/features.hpp"
#include "slam_core/visual_odometry/keypoint_detector.hpp"

namespace slam::visual_odometry {

/// Keypoints that are found again by their descriptors: two match when each is the nearest to the
/// other of all that lie within the window.
class DescribedFeatures final : public FeaturePolicy {
 public:
  explicit DescribedFeatures(std::unique_ptr<KeypointDetector> detector)
      : detector_(std::move(detector)) {}

  bool countsFeatures() const override { return true; }
  double dependence() const override { return detector_->dependence(); }
  Features extract(const cv::Mat& gray, const CeilingView& view) override;
  void prepareReference(Features& /*features*/, const CeilingView& /*view*/) const override {}
  PointMatches match(const Features& reference, const Features& now, const CeilingView& view,
                     const SearchWindow& window) const override;

 private:
  std::unique_ptr<KeypointDetector> detector_;
};

}  // namespace slam::visual_odometry
