// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/mixture.hpp"

#include <algorithm>

namespace slam::particle_filter {
namespace {

/// Few or equal particles have no spread in some direction; a covariance needs one [m^2, rad^2].
constexpr double kSmallestVariance = 1e-12;

}  // namespace

PoseEstimate momentsOf(const std::vector<PoseGaussian>& parts, const std::vector<double>& weights) {
  const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  const Pose2 reference = parts[static_cast<std::size_t>(heaviest)].mean;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i)
    mean += weights[i] * difference(parts[i].mean, reference);
  PoseEstimate estimate{Pose2::fromVector(reference.vector() + mean),
                        kSmallestVariance * Eigen::Matrix3d::Identity()};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto d = difference(parts[i].mean, estimate.pose);
    estimate.covariance += weights[i] * (parts[i].covariance + d * d.transpose());
  }
  estimate.covariance = (0.5 * (estimate.covariance + estimate.covariance.transpose())).eval();
  return estimate;
}

PoseEstimate about(const Pose2& pose, const PoseEstimate& estimate) {
  const auto d = difference(estimate.pose, pose);
  return {pose, estimate.covariance + d * d.transpose()};
}

Landmark mixtureOf(const ParticleSet& particles, std::size_t slot, LandmarkId id) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i)
    mean += particles.weights()[i] * particles[i].map[slot].mean();
  return mixtureAbout(mean, particles, slot, id);
}

Landmark mixtureAbout(const Eigen::Vector2d& point, const ParticleSet& particles, std::size_t slot,
                      LandmarkId id) {
  Eigen::Matrix2d P = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto& landmark = particles[i].map[slot];
    const Eigen::Vector2d d = landmark.mean() - point;
    P += particles.weights()[i] * (landmark.covariance() + d * d.transpose());
  }
  return {id, point, P};
}

}  // namespace slam::particle_filter
