// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/choice.hpp"
#include "slam_core/common/config_fields.hpp"

namespace slam::visual_odometry {

/// What is found again from image to image: ORB (Rublee et al. 2011), corners tracked by KLT,
/// AKAZE (Alcantarilla et al. 2013), SIFT (Lowe 2004), SURF (Bay et al. 2008; the thesis's).
enum class FeatureKind { kOrb, kKlt, kAkaze, kSift, kSurf };

const Names<FeatureKind>& featureNames();

struct VisualOdometryConfig {
  static constexpr const char* kSection = "visual_odometry";

  FeatureKind features = FeatureKind::kOrb;
  int max_features = 500;
  int min_inliers = 15;
  double keyframe_share = 0.5;
  double inlier_distance = 2.0;
  double scale_tolerance = 0.03;
  double patience = 1.0;

  double ceiling_height = 0.0;
  double max_speed = 1.5;
  double max_turn_rate = 2.0;
  double pixel_sigma = 0.1;
  double alpha_translation = 4e-5;
  double alpha_rotation = 1e-6;
  double floor_position = 0.0002;
  double floor_heading = 0.0001;

  void describe(Fields& fields);
  /// @throw ConfigError when the robot file does not tell the ceiling's height
  void requireHeight() const;
};

}  // namespace slam::visual_odometry
