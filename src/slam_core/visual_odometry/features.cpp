// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/features.hpp"

#include "slam_core/visual_odometry/described_features.hpp"
#include "slam_core/visual_odometry/tracked_features.hpp"

namespace slam::visual_odometry {

std::unique_ptr<FeaturePolicy> makeFeaturePolicy(FeatureKind kind, int max_features) {
  if (kind == FeatureKind::kKlt) return std::make_unique<TrackedFeatures>(max_features);
  return std::make_unique<DescribedFeatures>(makeKeypointDetector(kind, max_features));
}

}  // namespace slam::visual_odometry
