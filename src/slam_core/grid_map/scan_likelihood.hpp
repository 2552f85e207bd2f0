// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_points.hpp"

namespace slam::grid_map {

/// How likely a scan is from a pose in a map: for each end the likelihood that the map's cells
/// have, between them interpolated, mixed with that of an end that has nothing to do with the map
/// (the likelihood field of Thrun, Burgard, Fox 2005, ch. 6.4).
class ScanLikelihood {
 public:
  /// @param outlier likelihood of an end that has nothing to do with the map, relative to the
  /// largest
  /// @param weight of an end's log likelihood: neighbouring beams are not independent
  ScanLikelihood(double outlier, double weight);

  /// Not above 0, which is where all ends fit best.
  /// @param pose T_map_base
  double log(const GridMap& map, const ScanPoints& scan, const Pose2& pose) const;

  /// The logarithm for an end in a cell of this likelihood.
  float log(std::uint8_t likelihood) const { return logs_[likelihood]; }

 private:
  std::array<float, 256> logs_;
};

/// What a matcher makes as large as it can: the logarithm of the likelihood of a scan times the
/// density of the motion that led there.
class MatchObjective {
 public:
  /// All must outlive this.
  /// @param prior T_map_base as motion has it, with its covariance, which is not singular
  MatchObjective(const ScanLikelihood& likelihood, const GridMap& map, const ScanPoints& scan,
                 const Pose2& prior, const Eigen::Matrix3d& covariance);

  double log(const Pose2& pose) const {
    return likelihood_.log(map_, scan_, pose) + logPrior(pose);
  }
  /// The logarithm of the prior's density, up to a constant.
  double logPrior(const Pose2& pose) const;

  const ScanLikelihood& likelihood() const { return likelihood_; }
  const GridMap& map() const { return map_; }
  const ScanPoints& scan() const { return scan_; }
  const Pose2& prior() const { return prior_; }
  /// The standard deviations of the prior, in x, y [m] and heading [rad].
  const Eigen::Vector3d& sigma() const { return sigma_; }

 private:
  const ScanLikelihood& likelihood_;
  const GridMap& map_;
  const ScanPoints& scan_;
  Pose2 prior_;
  Eigen::Matrix3d information_;
  Eigen::Vector3d sigma_;
};

}  // namespace slam::grid_map
