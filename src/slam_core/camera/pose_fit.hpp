// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "slam_core/camera/normalised_camera.hpp"

namespace slam {

/// A known point [m] and where the camera saw it on the plane z = 1.
struct PoseSighting {
  Eigen::Vector3d point;
  Eigen::Vector2d seen;
  double sigma;  ///< along each axis of the plane
};

/// What is known of a pose beside the points.
struct PosePrior {
  Pose2 pose;
  Eigen::Matrix3d covariance;  ///< of (x, y, theta), positive definite
};

struct FittedPose {
  Pose2 pose;
  Eigen::Matrix3d information;  ///< of the points that fit, about (x, y, theta)
  Eigen::Matrix3d covariance;   ///< with the prior
  std::vector<bool> fits;       ///< by sighting
  std::size_t count = 0;        ///< of those that fit
};

/// The pose on the plane from which points are seen as they are: Gauss-Newton with Huber's weights,
/// then with the points alone that fit (chi-square with two degrees of freedom at 0.95; Mur-Artal
/// et al. 2015, appendix). Nothing where points and prior do not determine it.
std::optional<FittedPose> fitPose(const NormalisedCamera& camera,
                                  const std::vector<PoseSighting>& sightings, const Pose2& start,
                                  const std::optional<PosePrior>& prior);

/// How many sightings fit a pose.
std::size_t countFits(const NormalisedCamera& camera, const std::vector<PoseSighting>& sightings,
                      const Pose2& pose);

}  // namespace slam
