// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/difference.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::particle_filter {

/// A Gaussian over a pose; the covariance may be zero.
struct PoseGaussian {
  Pose2 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  bool isCertain() const { return covariance.isZero(0.0); }
  /// Of the pose after a motion from here.
  PoseGaussian moved(const Motion& motion) const;
  Pose2 sample(RandomStream& random) const;
  double logDensity(const Pose2& pose) const;  ///< not of a certain one

  template <class Archive>
  void persist(Archive& archive) {
    archive(mean, covariance);
  }
};

}  // namespace slam::particle_filter
