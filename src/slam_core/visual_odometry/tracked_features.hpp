// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/visual_odometry/features.hpp"

namespace slam::visual_odometry {

/// Corners of the reference (Shi and Tomasi 1994) that are tracked into the present image (Lucas
/// and Kanade 1981, on a pyramid: Bouguet 2001), from where the window expects them. They are half
/// as many as of other features: each is placed more exactly and takes more time.
class TrackedFeatures final : public FeaturePolicy {
 public:
  explicit TrackedFeatures(int max_features) : max_features_(max_features) {}

  bool countsFeatures() const override { return false; }
  double dependence() const override { return 1.5; }
  Features extract(const cv::Mat& gray, const CeilingView& view) override;
  void prepareReference(Features& features, const CeilingView& view) const override;
  PointMatches match(const Features& reference, const Features& now, const CeilingView& view,
                     const SearchWindow& window) const override;

 private:
  int max_features_;
};

}  // namespace slam::visual_odometry
