// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "slam_core/contract/association_chooser.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/particle_filter/filter/pf_config.hpp"
#include "slam_core/particle_filter/landmarks/landmark_update.hpp"
#include "slam_core/particle_filter/particles/particle_set.hpp"
#include "slam_core/particle_filter/particles/resampler.hpp"
#include "slam_core/particle_filter/particles/sensor_update.hpp"
#include "slam_core/particle_filter/scans/scan_update.hpp"

namespace slam::particle_filter {

/// A Rao-Blackwellised particle filter over the robot's path, each particle with a map of its own
/// (thesis 5.4, 5.7; Montemerlo 2003; Grisetti, Stachniss, Burgard 2007). What a sensor does to the
/// particles is that sensor's SensorUpdate: LandmarkUpdate makes it FastSLAM, ScanUpdate a filter
/// with grid maps; with both, observations and scans come in turn. With a grid, particles are not
/// propagated until an observation comes or a scan is due for an update. Scans in between only
/// correct the motion that has been accumulated, and reduce each particle's deviation from it.
class FastSlam final : public Backend,
                       CorrectionReporter,
                       LandmarkMapper,
                       LandmarkRemover,
                       GridMapper,
                       LostReporter,
                       PoseSampler,
                       PathReviser,
                       MapKeeper,
                       MapChooser,
                       AssociationChooser {
 public:
  /// The grid's parameters count only where one is used. @throw ConfigError
  void configure(const PfConfig& config, const grid_map::GridMapConfig& grid = {},
                 const ScanConfig& scan = {}, const scan_matching::MatcherConfig& matcher = {});
  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { execution_.streams.seed(seed); }

  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  Status execute() override;
  PoseEstimate pose() const override;
  Counters counters() const override { return account_.counters; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  const ParticleSet& particleSet() const { return *particles_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(*particles_, landmarks_, belief_, inputs_, account_, execution_.streams, is_corrected_);
    if (scans_) archive(*scans_);
    bool is_shown = shown_grid_.identity == best().grid.identity();
    archive(is_shown, shown_grid_.revision);
    if constexpr (Archive::kReads) shown_grid_.identity = is_shown ? best().grid.identity() : this;
  }

 private:
  /// These inputs were set since the last step.
  struct Inputs {
    std::optional<MapState> map;
    std::optional<PoseEstimate> initial_pose;
    std::optional<Motion> motion;  ///< all motions as one
    std::optional<LandmarkObservationArray> observations;
    std::optional<LaserScan> scan;

    void set(const Motion& next) { motion = motion ? joined(*motion, next) : next; }
    void set(const LandmarkObservationArray& array) { observations = array; }
    void set(const LaserScan& latest) { scan = latest; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(map, initial_pose, motion, observations, scan);
    }
  };
  /// What a step begins with.
  struct Step {
    Stamp stamp;
    std::optional<Motion> latest;    ///< since the last step
    SensorUpdate* update = nullptr;  ///< of the sensor that saw something, or by motion alone
    bool has_seen = false;
    bool is_followed = false;  ///< by a scan, whether that is due for an update or not
  };
  struct ShownGrid {
    const void* identity = nullptr;
    std::uint64_t revision = 0;
  };

  // what it offers as capabilities
  std::optional<Stamp> correctedBy() const override;
  LandmarkMap landmarks() const override;
  UpdateStatistics statistics() const override { return account_.statistics; }
  Status remove(LandmarkId id) override { return landmarks_.remove(id, account_); }
  std::optional<OccupancyGrid> grid() const override;
  std::uint64_t gridRevision() const override { return shown_grid_.revision; }
  std::optional<Stamp> lostSince() const override;
  std::vector<Pose2> particles() const override;
  std::vector<StampedPose> path() const override;
  MapState state() const override;
  void set(const MapState& map) override { inputs_.map = map; }
  std::vector<MapKind> maps() const override { return {MapKind::kLandmarks, MapKind::kGrid}; }
  void useMap(MapKind map) override { uses_grid_ = map == MapKind::kGrid; }
  void useAssociation(const std::string& policy) override { association_ = policy; }

  Status replaceMap();
  void relocate();
  Step takeInputs();
  /// Corrects the accumulated motion and each particle's deviation from it by a scan.
  void correct(const ScanCorrection& correction, Step& step);
  Status carry(const Step& step);
  Drafts propose(const Step& step);
  Status weigh(const Drafts& drafts, SensorUpdate& update);
  PoseEstimate estimate(const Drafts& drafts, const Step& step);
  Ancestors resample(const Drafts& drafts, const PoseEstimate& moments);
  Status draw(const Drafts& drafts, const Ancestors& ancestors, const SensorUpdate& update);
  Status learn(const Ancestors& ancestors, const Step& step);
  Status summary(std::initializer_list<Status> of_steps);
  Status onTheWhole() const;

  const Particle& best() const { return (*particles_)[particles_->best()]; }
  /// The landmark with this number as the particles have it, by `pf.map`: the best one's, or that
  /// of all together.
  Landmark landmark(std::size_t number) const;
  std::vector<std::size_t> toldLandmarks() const;
  std::size_t landmarksInMap() const;
  bool tellsBest() const {
    return config_.pose == ToldPose::kBest || (config_.pose == ToldPose::kAuto && scans_);
  }
  /// Motion that has not been applied to the particles yet.
  Pose2 carriedIncrement() const { return belief_.carried ? belief_.carried->increment : Pose2(); }

  PfConfig config_;
  bool uses_grid_ = false;
  std::string association_ = "known_ids";
  Execution execution_;
  std::unique_ptr<ParticleSet> particles_;
  LandmarkUpdate landmarks_;
  std::optional<ScanUpdate> scans_;  ///< where a grid is made
  bool is_corrected_ = false;        ///< by the scan of the last step
  Resampler resampler_;
  PoseBelief belief_;
  Inputs inputs_;
  Account account_;
  ShownGrid shown_grid_;
};

}  // namespace slam::particle_filter
