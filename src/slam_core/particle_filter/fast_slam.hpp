// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/contract/backend.hpp"
#include "slam_core/particle_filter/fit_monitor.hpp"
#include "slam_core/particle_filter/knowledge_bound.hpp"
#include "slam_core/particle_filter/landmark_index.hpp"
#include "slam_core/particle_filter/particle_set.hpp"
#include "slam_core/particle_filter/policies.hpp"
#include "slam_core/particle_filter/random_streams.hpp"
#include "slam_core/particle_filter/step.hpp"
#include "slam_core/particle_filter/workers.hpp"

namespace slam::particle_filter {

/// FastSLAM: a Rao-Blackwellised particle filter over the robot's path, each particle with a map of
/// independent landmark filters (thesis 5.4; Montemerlo 2003; Thrun, Burgard, Fox 2005, ch. 13).
class FastSlam final : public Backend {
 public:
  /// @throw ConfigError
  void configure(const PfConfig& config);
  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { streams_.seed(seed); }

  void set(const Motion& motion) override;
  void set(const LandmarkObservationArray& observations) override {
    inputs_.observations = observations;
  }
  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  void set(const MapState& map) override { inputs_.map = map; }

  Status execute() override;

  PoseEstimate pose() const override;
  LandmarkMap landmarks() const override;
  MapState state() const override;
  UpdateStatistics statistics() const override { return told_.statistics; }
  const Counters& counters() const override { return told_.counters; }
  std::vector<Pose2> particles() const override;
  std::vector<StampedPose> path() const override;
  std::map<std::string, double> figures() const override { return told_.figures; }

  void reset() override;

  const ParticleSet& particleSet() const { return *particles_; }

 private:
  /// What was set since the last step.
  struct Inputs {
    std::optional<MapState> map;
    std::optional<PoseEstimate> initial_pose;
    std::optional<Motion> motion;  ///< all motions as one
    std::optional<LandmarkObservationArray> observations;
  };
  /// What the last step led to.
  struct Told {
    PoseEstimate estimate;  ///< of all particles, before the last resampling, and what they forgot
    UpdateStatistics statistics;
    Counters counters;
    std::map<std::string, double> figures;
  };

  void replaceMap();
  void relocate();
  void associate(Step& step);
  void propose(Step& step);
  bool weigh(Step& step);
  void estimate(Step& step);
  void resample(Step& step);
  bool draw(const Step& step);
  double drawParticle(const Step& step, std::size_t i, unsigned lane);
  void record(const Step& step);
  void beginAnew(const Step& step);
  Status status(const Step& step, bool weights_are_left) const;
  /// As the particles have it.
  Landmark landmark(std::size_t slot) const;
  bool mapIsFixed() const { return config_.mode == "localization"; }

  PfConfig config_;
  Policies policies_;
  RandomStreams streams_;
  std::unique_ptr<Workers> workers_;
  LandmarkIndex index_;
  std::unique_ptr<ParticleSet> particles_;
  FitMonitor fit_;
  KnowledgeBound bound_;
  /// Where the robot was told to be, until it sees something of its map. So long it is everybody's
  /// prior as a whole: of the poses drawn from it none may lie close enough to the true one.
  std::optional<PoseGaussian> told_place_;
  Inputs inputs_;
  Told told_;
};

}  // namespace slam::particle_filter
