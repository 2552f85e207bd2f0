// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"

namespace slam::relocalisation {

/// A scan and where it was taken.
struct LocalScan {
  scan_matching::ScanLevels points;
  Pose2 pose;   ///< T_local_base
  double gone;  ///< LocalScans::way() at the scan [m]

  template <class Archive>
  void persist(Archive& archive) {
    archive(points, pose, gone);
  }
};

/// The scans of the last metres, matched with one another. They need neither a map nor a pose. A
/// single scan often fits several places of a map; all of them together seldom do.
class LocalScans {
 public:
  /// @param way distance driven over which scans are kept [m]
  LocalScans(const grid_map::GridMapConfig& grid, const scan_matching::MatcherConfig& matcher,
             double way);

  /// Adds motion since the last scan.
  void move(const Motion& motion);
  /// @return whether the scan is kept: the robot has gone or turned a little since the last one
  bool take(const LaserScan& scan);
  void forget();

  /// Whether take() has forgotten all scans but the last one, since motion before it was missing
  /// for so long that nobody knows how they lie to it.
  bool hasBegunAnew() const { return has_begun_anew_; }

  bool isEmpty() const { return kept_.empty(); }
  /// The scans that are kept, the latest last.
  const std::deque<LocalScan>& kept() const { return kept_; }
  /// T_local_base at the last scan. The local frame is the robot's at the first scan after
  /// forget().
  const Pose2& robot() const { return tracker_.robot().pose; }
  /// Distance driven since forget() [m].
  double way() const { return gone_; }
  /// The ends of all scans that are kept, in the robot's frame.
  scan_matching::ScanLevels together() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(tracker_, trigger_, drawn_, kept_, carried_, gone_, has_begun_anew_);
    archive.made(map_, [this] { return std::make_unique<scan_matching::ScanMap>(config_); });
  }

 private:
  void keep(const scan_matching::ScanLevels& points);
  void redraw();

  grid_map::GridMapConfig config_;
  double way_, spacing_;
  scan_matching::LevelModels models_;
  scan_matching::ScanTracker tracker_;
  scan_matching::InsertionTrigger trigger_;
  std::unique_ptr<scan_matching::ScanMap> map_;  ///< of the kept scans and of some older ones
  std::size_t drawn_ = 0;                        ///< scans in the map
  std::deque<LocalScan> kept_;
  std::optional<Motion> carried_;
  double gone_ = 0.0;
  bool has_begun_anew_ = false;
};

}  // namespace slam::relocalisation
