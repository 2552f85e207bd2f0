// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/grid_map/grid_map_config.hpp"
#include "slam_core/particle_filter/particles/sensor_update.hpp"
#include "slam_core/particle_filter/scans/scan_config.hpp"
#include "slam_core/particle_filter/scans/scan_follower.hpp"
#include "slam_core/particle_filter/scans/scan_proposal.hpp"
#include "slam_core/particle_filter/scans/scan_weighting.hpp"
#include "slam_core/particle_filter/scans/update_trigger.hpp"
#include "slam_core/scan_matching/map_drift.hpp"
#include "slam_core/scan_matching/scan_doubt.hpp"
#include "slam_core/scan_matching/scan_watch.hpp"

namespace slam::particle_filter {

/// Laser scans in the filter, whose particles carry grid maps (Grisetti, Stachniss, Burgard 2007;
/// thesis 5.7). Every scan corrects the motion (ScanFollower); after some way one updates the
/// particles.
class ScanUpdate final : public SensorUpdate {
 public:
  /// No scan has come yet. @param map, scan, matcher are valid
  ScanUpdate(const grid_map::GridMapConfig& map, const ScanConfig& scan,
             const scan_matching::MatcherConfig& matcher, bool map_is_fixed);

  /// The map starts, empty, at this pose.
  void restart(const PoseEstimate& first);
  /// A map was loaded, with the robot at this pose.
  void restartInLoadedMap(const Pose2& robot);
  /// The next scan is used wherever the robot is.
  /// @param around a pose: by its covariance a particle may be off, beyond what it was drawn by
  void relocate(const PoseEstimate& around);
  void move(const Motion& motion);
  /// @return whether the scan is due for an update and has beams that tell something
  /// @param best the most likely particle @param pose where the wheels have led it since the last
  /// scan
  bool take(const LaserScan& scan, const Particle& best, const Pose2& pose, Account& account);
  /// What the last scan taken makes of the motion up to it.
  const ScanCorrection& correction() const { return correction_; }

  Drafts propose(const ParticleSet& particles, const std::optional<Motion>& motion,
                 const PoseBelief& belief, const Execution& execution) override;
  void inform(const PoseEstimate& moments, const ParticleSet& particles,
              KnowledgeBound& bound) const override;
  Lesson learn(ParticleSet& particles, const Ancestors& ancestors, PoseBelief& belief,
               const Execution& execution, Account& account) override;

  /// Whether the scans still fit the map of the most likely particle.
  const scan_matching::ScanDoubt& doubt() const { return doubt_; }
  /// Says whether the latest scans tell where the robot is.
  Status status() const { return moreUrgent(doubt_.status(), watch_.status()); }
  const scan_matching::LevelModels& models() const { return models_; }
  /// Tiles in the rectangle of the largest map.
  std::size_t mostTiles() const { return grid_map::mostTiles(map_config_); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(follower_, drift_, trigger_, doubt_, watch_, told_, correction_, stamp_, motion_,
            scan_);
  }

 private:
  scan_matching::MapView mapOf(const Particle& particle) const;
  ScanInMap inMapOf(const Particle& particle) const;
  /// The covariance by which a particle that is here may be off since the last scan. What landmarks
  /// have said since has moved the particles: that tells where to look, not how sure the place is.
  Eigen::Matrix3d covarianceAt(const Pose2& pose) const;
  /// @return the covariance that the surfaces around this pose have relative to the oldest ones;
  /// nothing if the map is fixed
  std::optional<Eigen::Matrix3d> driftAt(const Pose2& pose) const;
  Lesson insert(ParticleSet& particles, const Execution& execution, Account& account);
  /// Whether as many maps may take the scan in without needing more memory than there is.
  bool hasRoomFor(std::size_t maps, const grid_map::GridMap::Memory& memory) const;

  grid_map::GridMapConfig map_config_;
  ScanConfig config_;
  double spacing_;
  bool map_is_fixed_;
  scan_matching::LevelModels models_;
  scan_matching::ScanEvidence evidence_;
  std::unique_ptr<ScanProposal> proposal_;
  std::unique_ptr<ScanWeighting> weighting_;
  ScanFollower follower_;
  scan_matching::MapDrift drift_;
  UpdateTrigger trigger_;
  scan_matching::ScanDoubt doubt_;
  scan_matching::ScanWatch watch_;
  std::optional<Motion> told_;  ///< by how much the robot may be off the place that it was given
  ScanCorrection correction_;

  // of the step
  Stamp stamp_;
  Motion motion_;  ///< since the last update
  scan_matching::ScanLevels scan_;
};

}  // namespace slam::particle_filter
