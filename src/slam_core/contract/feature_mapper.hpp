// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace slam {

/// A point of the world that a camera recognises by how it looks, in the map frame.
struct MappedFeature {
  std::uint64_t id = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    ///< [m], z up from the robot's plane
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< marginal [m^2]
};

/// The capability of a back-end that maps features of images as points in space.
class FeatureMapper {
 public:
  virtual ~FeatureMapper() = default;
  /// The features whose depth is known, sorted by id.
  virtual std::vector<MappedFeature> features() const = 0;
};

}  // namespace slam
