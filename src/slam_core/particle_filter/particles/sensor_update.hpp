// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/particle_filter/particles/knowledge_bound.hpp"
#include "slam_core/particle_filter/particles/particle_set.hpp"
#include "slam_core/particle_filter/particles/pose_gaussian.hpp"
#include "slam_core/particle_filter/particles/random_streams.hpp"
#include "slam_core/particle_filter/particles/workers.hpp"

namespace slam::particle_filter {

/// What the particles make of a step before their new poses are drawn; one of each for a particle.
struct Drafts {
  explicit Drafts(std::size_t particles)
      : priors(particles), proposals(particles), log_factors(particles) {}

  std::vector<PoseGaussian> priors;     ///< where motion alone puts it
  std::vector<PoseGaussian> proposals;  ///< what its new pose is to be drawn from
  std::vector<double> log_factors;      ///< logarithm of the factor on its weight
};

/// For each particle the one whose copy it is, and whose drafts are its own.
using Ancestors = std::vector<std::uint32_t>;

/// What is known of the pose beside the particles.
struct PoseBelief {
  PoseEstimate estimate;  ///< of all particles before the last resampling, and of those it dropped
  KnowledgeBound bound;
  /// The initial pose that was set, until the robot sees something of its map. So long it is every
  /// particle's prior as a whole: of the poses drawn from it none may lie close enough to the true
  /// one.
  std::optional<PoseGaussian> told_place;
  std::optional<Motion> carried;  ///< motion that has not been applied to the particles yet

  template <class Archive>
  void persist(Archive& archive) {
    archive(estimate, bound, told_place, carried);
  }
};

/// What works on all particles.
struct Execution {
  RandomStreams streams;
  std::unique_ptr<Workers> workers;
};

/// What is reported of the steps beside pose and map.
struct Account {
  UpdateStatistics statistics;  ///< of the last step
  Counters counters;
  std::map<std::string, double> figures;

  template <class Archive>
  void persist(Archive& archive) {
    archive(statistics, counters, figures);
  }
};

/// What a step has put into the particles' maps.
struct Lesson {
  Status status;
  bool changes_grids = false;
};

/// One kind of sensor in the filter: how what it saw moves and weighs the particles, and goes into
/// their maps. It is given its input before; then the filter calls, in the order of the
/// declarations and once a step, what follows. Particles are drawn anew between inform() and
/// logCorrection().
class SensorUpdate {
 public:
  virtual ~SensorUpdate() = default;

  /// @param motion since the particles were moved last
  virtual Drafts propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                         const PoseBelief& belief, const Execution& execution) = 0;
  /// Judges how well the particles together have predicted what was seen.
  /// @param weights before the step
  virtual void judge([[maybe_unused]] const Weights& weights, [[maybe_unused]] Account& account) {}
  /// What can be known now of pose and landmarks at best.
  /// @param moments of the pose, from all proposals by the new weights
  virtual void inform(const PoseEstimate& moments, const ParticleSet& particles,
                      KnowledgeBound& bound) const = 0;
  /// The logarithm of the factor that the pose drawn makes necessary; for several threads at once.
  virtual double logCorrection(const Drafts& /*drafts*/, std::size_t /*ancestor*/,
                               const Particle& /*drawn*/) const {
    return 0.0;
  }
  /// What was seen goes into the particles' maps, unless these are fixed.
  virtual Lesson learn(ParticleSet& particles, const Ancestors& ancestors, PoseBelief& belief,
                       const Execution& execution, Account& account) = 0;
};

}  // namespace slam::particle_filter
