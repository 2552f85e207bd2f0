// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/grid_slam/grid_slam_config.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/scan_matching/map_drift.hpp"
#include "slam_core/scan_matching/scan_doubt.hpp"
#include "slam_core/scan_matching/scan_map.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"
#include "slam_core/scan_matching/scan_watch.hpp"

namespace slam::grid_slam {

/// SLAM by matching each scan with one occupancy grid in several resolutions (Kohlbrecher et al.
/// 2011; thesis, Table 3.1). It needs no odometry; if motion comes, it predicts the pose at which
/// to match. No loops are closed: errors of matching add up in the map.
///
/// The reported covariance is the sum of that of the robot relative to the parts of the map around
/// it, and that of these parts (MapDrift). Counted: what ScanWatch counts; "contradicting" scans,
/// which are not added to the map; "scans_without_memory"; "beams_beyond_map".
class GridSlam final : public Backend, CorrectionReporter, GridMapper, LostReporter, MapKeeper {
 public:
  /// @throw ConfigError
  void configure(const GridSlamConfig& config, const grid_map::GridMapConfig& grid,
                 const scan_matching::MatcherConfig& matcher);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  Status execute() override;
  PoseEstimate pose() const override;
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive.made(map_, [this] { return std::make_unique<scan_matching::ScanMap>(map_config_); });
    archive(revision_, tracker_, trigger_, drift_, carried_, doubt_, watch_, is_corrected_, inputs_,
            counters_);
  }

 private:
  /// The inputs that were set since the last step.
  struct Inputs {
    std::optional<MapState> map;
    std::optional<PoseEstimate> initial_pose;
    std::optional<Motion> motion;  ///< all motions as one
    std::optional<LaserScan> scan;

    void set(const Motion& next) { motion = motion ? joined(*motion, next) : next; }
    void set(const LaserScan& latest) { scan = latest; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(map, initial_pose, motion, scan);
    }
  };

  // the capabilities that it offers
  std::optional<Stamp> correctedBy() const override;
  std::optional<OccupancyGrid> grid() const override;
  std::uint64_t gridRevision() const override { return revision_; }
  std::optional<Stamp> lostSince() const override { return doubt_.lostSince(); }
  MapState state() const override;
  void set(const MapState& map) override { inputs_.map = map; }

  bool mapIsFixed() const { return config_.mode == BackendMode::kLocalization; }
  Status replaceMap();
  void relocate();
  /// Adds the motion of this step to the motion since the last scan.
  void move();
  scan_matching::Match match(const scan_matching::ScanLevels& scan, Stamp stamp);
  Status learn(const scan_matching::ScanLevels& scan, const scan_matching::Match& found);
  Status insert(const scan_matching::ScanLevels& scan, const scan_matching::Match& found);
  Status onTheWhole() const;

  GridSlamConfig config_;
  grid_map::GridMapConfig map_config_;
  scan_matching::LevelModels models_;
  double spacing_ = 0.0;
  std::unique_ptr<scan_matching::ScanMap> map_;
  std::uint64_t revision_ = 0;
  scan_matching::ScanTracker tracker_;
  scan_matching::InsertionTrigger trigger_{0.0, 0.0};
  scan_matching::MapDrift drift_{0.0, 0.0};
  std::optional<Motion> carried_;  ///< since the last scan
  scan_matching::ScanDoubt doubt_;
  scan_matching::ScanWatch watch_;
  bool is_corrected_ = false;  ///< by the scan of the last step
  Inputs inputs_;
  Counters counters_;
};

}  // namespace slam::grid_slam
