// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/contract/backend.hpp"
#include "slam_core/particle_filter/fit_monitor.hpp"
#include "slam_core/particle_filter/landmark_index.hpp"
#include "slam_core/particle_filter/particle_set.hpp"
#include "slam_core/particle_filter/pf_config.hpp"
#include "slam_core/particle_filter/proposal.hpp"
#include "slam_core/particle_filter/resampling.hpp"
#include "slam_core/particle_filter/weighting.hpp"

namespace slam::particle_filter {

/// FastSLAM: a Rao-Blackwellised particle filter over the robot's path, each particle with a map of
/// independent landmark filters (thesis 5.4; Montemerlo 2003; Thrun, Burgard, Fox 2005, ch. 13).
class FastSlam final : public Backend {
 public:
  /// @throw ConfigError
  void configure(const PfConfig& config);
  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { seed_ = seed; }

  void set(const Motion& motion) override;
  void set(const LandmarkObservationArray& observations) override { observations_ = observations; }
  void set(const PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }
  void set(const MapState& map) override { map_ = map; }

  Status execute() override;

  PoseEstimate pose() const override;
  LandmarkMap landmarks() const override;
  MapState state() const override;
  UpdateStatistics statistics() const override { return statistics_; }
  const Counters& counters() const override { return counters_; }
  std::vector<Pose2> particles() const override;
  std::vector<StampedPose> path() const override { return particles_->best().path.poses(); }
  std::map<std::string, double> figures() const override { return figures_; }

  void reset() override;

  const ParticleSet& particleSet() const { return *particles_; }

 private:
  enum class Purpose : std::uint32_t { kPropose, kDraw, kResample, kResize, kPlace };
  struct Step;

  RandomStream random(Purpose purpose, std::size_t particle = 0) const;
  void replaceMap();
  void relocate();
  void associate(Step& step);
  void propose(Step& step);
  bool weigh(Step& step);
  void estimate(const Step& step);
  void resample(Step& step);
  bool draw(const Step& step);
  double drawParticle(const Step& step, std::size_t i, unsigned lane);
  Status status(const Step& step, bool weights_are_left) const;

  PfConfig config_;
  std::uint64_t seed_ = 1, step_ = 0;
  double gate_ = 0.0;  ///< largest squared Mahalanobis distance
  RangeBearingModel model_;
  std::unique_ptr<Proposal> proposal_;
  std::unique_ptr<Weighting> weighting_;
  std::unique_ptr<Resampling> resampling_;

  LandmarkIndex index_;
  std::unique_ptr<ParticleSet> particles_;
  FitMonitor fit_;
  PoseEstimate estimate_;  ///< of all particles, before the last resampling
  UpdateStatistics statistics_;
  Counters counters_;
  std::map<std::string, double> figures_;

  std::optional<MapState> map_;
  std::optional<PoseEstimate> initial_pose_;
  std::optional<Motion> motion_;  ///< all motions since the last step as one
  std::optional<LandmarkObservationArray> observations_;
};

}  // namespace slam::particle_filter
