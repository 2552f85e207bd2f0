// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/particle_candidates.hpp"

#include <cmath>

namespace slam::particle_filter {

using association::Candidate;
using association::Pairing;

std::optional<std::size_t> PlaceCandidates::find(LandmarkId id) const {
  const auto number = index_.find(id);
  return number ? slotOf(*number, map_) : std::nullopt;
}

std::optional<Expectation> PlaceCandidates::expectation(const Pairing& pairing) const {
  return expect(model_, prior_.mean, array_.sensor_pose, map_[pairing.landmark],
                array_.observations[pairing.observation]);
}

void PlaceCandidates::candidates(std::size_t observation,
                                 std::vector<Candidate>& candidates) const {
  const auto& z = array_.observations[observation];
  Eigen::Matrix<double, 2, 3> J_robot;
  Eigen::Matrix2d J_z;
  const Eigen::Vector2d place =
      model_.invert(prior_.mean, array_.sensor_pose, z.vector(), &J_robot, &J_z);
  const double sigma = std::sqrt((J_robot * prior_.covariance * J_robot.transpose()).trace() +
                                 (J_z * z.covariance * J_z.transpose()).trace());
  for (std::size_t slot = 0; slot < map_.size(); ++slot) {
    const auto& landmark = map_[slot];
    const double both = sigma + std::sqrt(landmark.xx + landmark.yy);
    if (!((landmark.mean() - place).squaredNorm() <= gate_ * both * both)) continue;
    if (index_.isRetired(landmark.number)) continue;
    const auto e = expectation({observation, slot});
    if (!e) continue;
    const auto& H = e->H_robot;
    candidates.push_back({slot, e->nu, H * prior_.covariance * H.transpose() + e->R});
  }
}

Eigen::Matrix2d PlaceCandidates::crossCovariance(const Pairing& first,
                                                 const Pairing& second) const {
  const auto a = expectation(first), b = expectation(second);
  if (!a || !b) return Eigen::Matrix2d::Zero();
  return a->H_robot * prior_.covariance * b->H_robot.transpose();
}

}  // namespace slam::particle_filter
