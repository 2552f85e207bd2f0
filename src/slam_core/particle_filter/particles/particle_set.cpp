// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/particle_set.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace slam::particle_filter {

ParticleSet::ParticleSet(std::size_t count, unsigned lanes, std::size_t most_tiles)
    : memory_{ParticleMap::Memory(lanes), grid_map::GridMap::Memory(most_tiles), {}},
      particles_(count, empty()),
      weights_(count) {}

Particle ParticleSet::empty() {
  return {Pose2(),
          ParticleMap(memory_.maps),
          grid_map::GridMap(memory_.grids),
          SharedPath(memory_.paths),
          grid_map::GridMap(memory_.grids),
          Pose2()};
}

bool ParticleSet::weigh(const std::vector<double>& log_factors) {
  const bool are_left = weights_.multiply(log_factors);
  for (std::size_t i = 0; i < size(); ++i)
    if (weights_[i] > to_become_best_ * weights_[best_]) best_ = i;
  return are_left;
}

void ParticleSet::replaceMaps(const LandmarkMap& map, double inflation,
                              const grid_map::GridMap& grid, const grid_map::GridMap& coarse) {
  ParticleMap shared(memory_.maps);
  for (const auto& landmark : map) {
    LandmarkEstimate estimate(landmark.position, inflation * inflation * landmark.covariance);
    estimate.credit = LandmarkEstimate::kMostCredit;
    estimate.number = static_cast<std::uint32_t>(shared.size());
    shared.push_back(estimate);
  }
  for (auto& particle : particles_) {
    particle.map = shared;
    particle.grid = grid;
    particle.coarse_grid = coarse;
    particle.path = SharedPath(memory_.paths);
  }
  memory_.paths.clearSteps();
  weights_.reset(size());
  best_ = 0;
}

void ParticleSet::resample(const std::vector<std::uint32_t>& ancestors) {
  std::vector<Particle> next;
  next.reserve(ancestors.size());
  for (const auto ancestor : ancestors) next.push_back(particles_[ancestor]);
  const auto best = std::find(ancestors.begin(), ancestors.end(), best_);
  best_ = best == ancestors.end() ? 0 : static_cast<std::size_t>(best - ancestors.begin());
  particles_ = std::move(next);
  weights_.reset(size());
}

void relocate(ParticleSet& particles, const Pose2& increment, const PoseEstimate& around,
              RandomStream& random) {
  const auto size = particles.size();
  const auto& weights = particles.weights();
  const Eigen::Matrix3d L = around.covariance.llt().matrixL();
  std::vector<Eigen::Vector3d> deviations(size, Eigen::Vector3d::Zero());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < size; ++i) {
    const double x = random.gaussian(), y = random.gaussian(), theta = random.gaussian();
    deviations[i] = L * Eigen::Vector3d(x, y, theta);
    mean += weights[i] * deviations[i];
  }
  const double others = 1.0 - weights[0];
  const bool is_centred = size > 2 && others > 0.0;  // a single other one would be no deviation
  for (std::size_t i = 0; i < size; ++i) {
    auto& particle = particles[i];
    particle.pose = particle.pose * increment;
    particle.path.append(particle.pose);
  }
  for (std::size_t i = 1; i < size; ++i) {
    if (is_centred) deviations[i] -= mean / others;
    particles[i].pose = Pose2::fromVector(around.pose.vector() + deviations[i]);
  }
  particles[0].pose = around.pose;
  for (std::size_t i = 0; i < size; ++i) particles[i].followed = particles[i].pose;
}

void record(ParticleSet& particles, Stamp stamp, const Pose2& odometry, bool has_learned) {
  particles.memory().paths.addStep(stamp, odometry);
  if (!has_learned) return;
  for (std::size_t i = 0; i < particles.size(); ++i) particles[i].path.append(particles[i].pose);
}

}  // namespace slam::particle_filter
