// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/visual_odometry/alignment.hpp"
#include "slam_core/visual_odometry/features.hpp"
#include "slam_core/visual_odometry/view.hpp"
#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// Finds the features of an image and how it lies to an earlier view. For each image in turn
/// beginImage(), then where it can be used take(), then align() with as many references as it
/// needs.
class ViewMatcher {
 public:
  /// @throw ConfigError when the installed OpenCV does not have the features
  void configure(const VisualOdometryConfig& config);
  void seed(std::uint64_t seed) { seed_ = seed; }
  void reset();

  /// Forgets what was found in the image before.
  void beginImage();
  /// The camera's view, which becomes `now`. Returns empty, or why it cannot be matched:
  /// "camera_direction", "few_features".
  std::string take(const CameraView& view, View& now);
  /// The same numbers in alignment(), its fault included.
  const Alignment& align(const View& reference, const View& now, const SearchWindow& window);
  /// To be called before a view is a reference.
  void prepare(View& view);

  const CeilingView& ceiling() const { return ceiling_; }
  /// How many features the image has; where features are tracked, its reference.
  std::size_t features() const { return features_; }
  /// What the last align() of this image has found.
  const PointMatches& matches() const { return matches_; }
  const Alignment& alignment() const { return alignment_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(images_, features_);
  }

 private:
  void countTracked(const Features& reference);

  VisualOdometryConfig config_;
  std::unique_ptr<FeaturePolicy> policy_;
  std::uint64_t seed_ = 1, images_ = 0;
  CeilingView ceiling_;
  std::size_t features_ = 0;
  PointMatches matches_;
  Alignment alignment_;
};

}  // namespace slam::visual_odometry
