// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/mixture.hpp"

#include <algorithm>

namespace slam::particle_filter {
namespace {

/// Few or equal particles have no spread in some direction; a covariance needs one [m^2, rad^2].
constexpr double kSmallestVariance = 1e-12;

/// Calls use(weight, estimate) for each particle that has the landmark.
/// @return their share of the weight
template <class Use>
double forEachEstimate(const ParticleSet& particles, std::size_t number, const Use& use) {
  double share = 0.0;
  bool have_all = true;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto* const landmark = find(number, particles[i].map);
    have_all &= landmark != nullptr;
    if (landmark == nullptr) continue;
    share += particles.weights()[i];
    use(particles.weights()[i], *landmark);
  }
  return have_all ? 1.0 : share;
}

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

Landmark mixtureOf(const ParticleSet& particles, std::size_t number, LandmarkId id) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  const double share = forEachEstimate(
      particles, number,
      [&](double weight, const LandmarkEstimate& landmark) { mean += weight * landmark.mean(); });
  return mixtureAbout(mean / share, particles, number, id);
}

Landmark mixtureAbout(const Eigen::Vector2d& point, const ParticleSet& particles,
                      std::size_t number, LandmarkId id) {
  Eigen::Matrix2d P = Eigen::Matrix2d::Zero();
  const double share =
      forEachEstimate(particles, number, [&](double weight, const LandmarkEstimate& landmark) {
        const Eigen::Vector2d d = landmark.mean() - point;
        P += weight * (landmark.covariance() + d * d.transpose());
      });
  return {id, point, P / share};
}

}  // namespace slam::particle_filter
