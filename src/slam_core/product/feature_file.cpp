// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/feature_file.hpp"

#include <fmt/core.h>

namespace slam {

std::string featureTable(const std::vector<MappedFeature>& features) {
  std::string table = "id,x,y,z,sigma_x,sigma_y,sigma_z\n";
  for (const auto& [id, position, covariance] : features) {
    const Eigen::Vector3d sigmas = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    table += fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", id, position.x(),
                         position.y(), position.z(), sigmas.x(), sigmas.y(), sigmas.z());
  }
  return table;
}

}  // namespace slam
