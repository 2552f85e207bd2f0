// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/fusion_policy.hpp"

namespace slam::point_map {

std::unique_ptr<FusionPolicy> makeFusion(const PointMapConfig& config) {
  const bool is_aligned = config.fusion == PointMapConfig::Fusion::kAligned;
  return is_aligned ? makeAlignedFusion(config) : makeEuclideanFusion(config);
}

}  // namespace slam::point_map
