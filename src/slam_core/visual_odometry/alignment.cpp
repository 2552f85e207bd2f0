// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/alignment.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/visual_odometry/consensus.hpp"
#include "slam_core/visual_odometry/rigid_fit.hpp"

namespace slam::visual_odometry {
namespace {

constexpr int kRefinements = 3;  // of which matches are inliers

}  // namespace

Alignment align(const PointMatches& matches, const VisualOdometryConfig& config,
                RandomStream& random) {
  Alignment result;
  const auto enough = static_cast<std::size_t>(config.min_inliers);
  const auto refuse = [&](const char* reason) { return result.fault = reason, result; };
  // a match's sigma is that of the difference of two features
  const double threshold = config.inlier_distance / std::sqrt(2.0);

  if (auto consensus = findConsensus(matches, threshold, random))
    result.inliers = std::move(*consensus);
  if (result.inliers.size() < enough) return refuse("few_inliers");
  result.scale = fitSimilarity(result.inliers).scale;
  if (std::abs(result.scale - 1.0) > config.scale_tolerance) return refuse("scale");
  for (int i = 0; i < kRefinements; ++i) {
    result.T_reference_now = fitRigid(result.inliers);
    result.inliers = agreeing(matches, {1.0, result.T_reference_now}, threshold);
    if (result.inliers.size() < enough) return refuse("few_inliers");
  }
  result.T_reference_now = fitRigid(result.inliers);
  const double sigma =
      std::max(residualSigma(result.inliers, result.T_reference_now), config.pixel_sigma);
  result.covariance = sigma * sigma * rigidCovariance(result.inliers, result.T_reference_now);
  return result;
}

}  // namespace slam::visual_odometry
