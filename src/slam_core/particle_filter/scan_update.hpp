// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/grid_map/grid_map.hpp"
#include "slam_core/grid_map/scan_insertion.hpp"
#include "slam_core/grid_map/scan_points.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/particle_filter/scan_config.hpp"
#include "slam_core/particle_filter/scan_fit_monitor.hpp"
#include "slam_core/particle_filter/scan_proposal.hpp"
#include "slam_core/particle_filter/scan_weighting.hpp"
#include "slam_core/particle_filter/update_trigger.hpp"

namespace slam::particle_filter {

/// What laser scans do to particles that carry grid maps, as a configuration has it: when one is
/// used, how it moves and weighs a particle, and how it goes into the particle's map.
class ScanUpdate {
 public:
  /// @param configs are valid
  ScanUpdate(const grid_map::GridMapConfig& map, const ScanConfig& scan);

  /// As when no scan has come yet.
  /// @param around a pose: by its covariance a particle may be off, beyond what it was drawn by
  void restart(const PoseEstimate& around);
  void move(const Motion& motion);
  /// The scan for an update; nothing where none is due or it tells nothing.
  std::optional<grid_map::ScanPoints> take(const LaserScan& scan) const;
  /// How a scan fits the map that it goes into next.
  void judge(const grid_map::ScanPoints& scan, const Pose2& pose, const grid_map::GridMap& map) {
    fit_.judge(map, scan, pose);
  }
  const ScanFitMonitor& fit() const { return fit_; }
  /// The update with the scan that was taken is done.
  void markTaken(Stamp stamp);

  /// For several threads at once, as all that follows.
  /// How far a particle that is here may be off since the last scan: what landmarks have said since
  /// has moved the particles, which for the scan is where to look, not how sure that is.
  Eigen::Matrix3d covarianceAt(const Pose2& pose) const;
  /// @param log_factor on the particle's weight, written
  PoseGaussian propose(const grid_map::ScanPoints& scan, const grid_map::GridMap& map,
                       const PoseGaussian& prior, RandomStream& random, double& log_factor) const;
  /// @return how many beams end beyond the largest map
  std::size_t insert(const grid_map::ScanPoints& scan, const Pose2& pose,
                     grid_map::GridMap& map) const {
    return grid_map::insertScan(model_, scan, pose, map);
  }

  /// Whether as many maps may take a scan in without needing more memory than there is.
  bool hasRoomFor(const grid_map::ScanPoints& scan, std::size_t maps,
                  const grid_map::GridMap::Memory& memory) const;
  /// Tiles in the rectangle of the largest map.
  std::size_t mostTiles() const;
  const grid_map::BeamModel& model() const { return model_; }

 private:
  grid_map::GridMapConfig map_config_;
  ScanConfig config_;
  grid_map::BeamModel model_;
  grid_map::ScanLikelihood likelihood_;
  std::unique_ptr<ScanProposal> proposal_;
  std::unique_ptr<ScanWeighting> weighting_;
  UpdateTrigger trigger_;
  ScanFitMonitor fit_;
  std::optional<Motion> motion_;  ///< since the last update
};

}  // namespace slam::particle_filter
