// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/fusion_policy.hpp"

namespace slam::point_map {

std::vector<std::string> fusionNames() { return {"euclidean", "aligned"}; }

std::unique_ptr<FusionPolicy> makeFusion(const PointMapConfig& config) {
  return config.fusion == "aligned" ? makeAlignedFusion(config) : makeEuclideanFusion(config);
}

}  // namespace slam::point_map
