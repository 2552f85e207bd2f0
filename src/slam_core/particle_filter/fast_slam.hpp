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
#include "slam_core/particle_filter/scan_update.hpp"
#include "slam_core/particle_filter/step.hpp"
#include "slam_core/particle_filter/workers.hpp"

namespace slam::particle_filter {

/// FastSLAM: a Rao-Blackwellised particle filter over the robot's path, each particle with a map of
/// independent landmark filters (thesis 5.4; Montemerlo 2003; Thrun, Burgard, Fox 2005, ch. 13),
/// and where it makes a grid map with one of these as well (thesis 5.7; Grisetti, Stachniss,
/// Burgard 2007). Beside a grid, steps that see nothing do not touch the particles: the motion is
/// carried until something is seen.
class FastSlam final : public Backend {
 public:
  std::vector<std::string> maps() const override { return {"landmarks", "grid"}; }
  void useMap(const std::string& map) override { uses_grid_ = map == "grid"; }
  /// The grid's parameters count only where one is used. @throw ConfigError
  void configure(const PfConfig& config, const grid_map::GridMapConfig& grid = {},
                 const ScanConfig& scan = {});
  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { streams_.seed(seed); }

  void set(const Motion& motion) override;
  void set(const LandmarkObservationArray& observations) override {
    inputs_.observations = observations;
  }
  void set(const LaserScan& scan) override { inputs_.scan = scan; }
  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  void set(const MapState& map) override { inputs_.map = map; }

  bool usesScans() const override { return scans_.has_value(); }

  Status execute() override;

  PoseEstimate pose() const override;
  LandmarkMap landmarks() const override;
  MapState state() const override;
  UpdateStatistics statistics() const override { return told_.statistics; }
  const Counters& counters() const override { return told_.counters; }
  std::vector<Pose2> particles() const override;
  std::vector<StampedPose> path() const override;
  std::optional<OccupancyGrid> grid() const override;
  std::uint64_t gridRevision() const override { return told_.grid_revision; }
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
    std::optional<LaserScan> scan;
  };
  /// What the last step led to.
  struct Told {
    PoseEstimate estimate;  ///< of all particles, before the last resampling, and what they forgot
    std::uint64_t grid_revision = 0;
    Status grid_status;  ///< of the last step, where the grid is not all it should be
    UpdateStatistics statistics;
    Counters counters;
    std::map<std::string, double> figures;
  };

  void replaceMap();
  void relocate();
  void settle();
  void takeMotion(Step& step);
  void associate(Step& step);
  void takeScan(Step& step);
  Status carry(const Step& step);
  void propose(Step& step);
  void proposeFor(Step& step, std::size_t i);
  bool weigh(Step& step);
  void estimate(Step& step);
  void resample(Step& step);
  bool draw(const Step& step);
  double drawParticle(const Step& step, std::size_t i, unsigned lane);
  void record(const Step& step);
  void beginAnew(const Step& step);
  Status status(bool weights_are_left) const;
  /// As the particles have it.
  Landmark landmark(std::size_t slot) const;
  grid_map::GridMap gridOf(const MapState& map);
  void judgeScan(const Step& step);
  void insertScan(Step& step);
  bool tellsBest() const {
    return config_.pose == "best" || (config_.pose == "auto" && usesScans());
  }
  /// By which the particles are behind.
  Pose2 carriedIncrement() const { return carried_ ? carried_->increment : Pose2(); }
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
  bool uses_grid_ = false;
  std::optional<ScanUpdate> scans_;  ///< where a grid is made
  std::optional<Motion> carried_;    ///< since the particles were moved last
  Inputs inputs_;
  Told told_;
};

}  // namespace slam::particle_filter
