// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/particle_filter/particles/particle_set.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"

namespace slam::particle_filter {

/// Mean and covariance of a weighted mixture of Gaussians over the robot's pose. The heading's mean
/// is taken in the chart about the heaviest part. Taking the proposals' Gaussians instead of the
/// poses drawn from them leaves out the noise of the draw (Rao-Blackwell).
PoseEstimate momentsOf(const std::vector<PoseGaussian>& parts, const std::vector<double>& weights);

/// The second moment of an estimate about another pose than its mean.
PoseEstimate about(const Pose2& pose, const PoseEstimate& estimate);

/// Mean and covariance of one landmark over all particles that have it.
Landmark mixtureOf(const ParticleSet& particles, std::size_t number, LandmarkId id);
/// A point and the second moment about it.
Landmark mixtureAbout(const Eigen::Vector2d& point, const ParticleSet& particles,
                      std::size_t number, LandmarkId id);

}  // namespace slam::particle_filter
