// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/features.hpp"

#include "slam_core/visual_odometry/described_features.hpp"
#include "slam_core/visual_odometry/tracked_features.hpp"

namespace slam::visual_odometry {

const std::vector<std::string>& featureNames() {
  static const std::vector<std::string> kNames = {"orb", "klt", "akaze", "sift", "surf"};
  return kNames;
}

std::unique_ptr<FeaturePolicy> makeFeaturePolicy(const std::string& name, int max_features) {
  if (name == "klt") return std::make_unique<TrackedFeatures>(max_features);
  return std::make_unique<DescribedFeatures>(makeKeypointDetector(name, max_features));
}

}  // namespace slam::visual_odometry
