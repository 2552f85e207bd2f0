// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/particle_filter/particles/particle.hpp"
#include "slam_core/particle_filter/particles/weights.hpp"

namespace slam::particle_filter {

/// What the particles share; must outlive them.
struct ParticleMemory {
  ParticleMap::Memory maps;
  grid_map::GridMap::Memory grids;
  SharedPath::Memory paths;
};

/// The particles with their weights and the memory they share.
class ParticleSet {
 public:
  /// `count` equal particles without a map, at the origin.
  /// @param most_tiles of the largest grid map
  ParticleSet(std::size_t count, unsigned lanes, std::size_t most_tiles = 0);
  ParticleSet(const ParticleSet&) = delete;
  ParticleSet& operator=(const ParticleSet&) = delete;

  std::size_t size() const { return particles_.size(); }
  Particle& operator[](std::size_t i) { return particles_[i]; }
  const Particle& operator[](std::size_t i) const { return particles_[i]; }
  const Weights& weights() const { return weights_; }
  /// The most likely particle, or where particles have just been resampled the first one that
  /// descends from it.
  std::size_t best() const { return best_; }
  /// Another particle becomes the best one where it is so many times as likely.
  void requireToBecomeBest(double factor) { to_become_best_ = factor; }

  /// Weights are multiplied with factors, see Weights. @return whether something was left of them
  bool weigh(const std::vector<double>& log_factors);
  /// Particle i is replaced by a copy of particle ancestors[i]; weights become equal.
  void resample(const std::vector<std::uint32_t>& ancestors);
  /// All particles get these maps, equal weights and an empty path.
  void replaceMaps(const LandmarkMap& map, double inflation, const grid_map::GridMap& grid,
                   const grid_map::GridMap& coarse);

  ParticleMemory& memory() { return memory_; }
  const ParticleMemory& memory() const { return memory_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(memory_.paths);
    archive.list(particles_, [this] { return empty(); });
    archive(weights_, best_);
    if constexpr (Archive::kReads)
      if (best_ >= particles_.size() || weights_.size() != particles_.size())
        throw std::runtime_error("it holds another number of particles: save it again");
  }

 private:
  Particle empty();

  ParticleMemory memory_;  // before those that live in it
  std::vector<Particle> particles_;
  Weights weights_;
  std::size_t best_ = 0;
  double to_become_best_ = 1.0;
};

/// All particles are moved by the same, where their paths end; then the poses are drawn anew around
/// one. Paths, maps and weights stay. The weighted mean of the poses is the one given, where there
/// are more than two, and the first particle's is exactly that.
void relocate(ParticleSet& particles, const Pose2& increment, const PoseEstimate& around,
              RandomStream& random);
/// The poses become the end of the paths.
/// @param odometry since the last call
/// @param has_learned the particles' poses are more than the last ones and the odometry
void record(ParticleSet& particles, Stamp stamp, const Pose2& odometry, bool has_learned);

}  // namespace slam::particle_filter
