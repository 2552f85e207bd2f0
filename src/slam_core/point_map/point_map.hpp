// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/contract/map_module.hpp"
#include "slam_core/models/filter_pose.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion_gap.hpp"
#include "slam_core/point_map/fusion_policy.hpp"
#include "slam_core/point_map/point_map_config.hpp"
#include "slam_core/point_map/point_set.hpp"
#include "slam_core/point_map/pose_collator.hpp"

namespace slam::point_map {

/// A map of points where a laser's beams end (thesis 5.6): scans, motion and the filter's poses in,
/// points out. It has no effect on the filter.
///
/// Call order: configure(), set(...) of what has come, execute() while isBusy(). Counted beyond the
/// collator's reasons: "invalid_motion", "invalid_pose", "bridged" (missing motion, made up for by
/// the odometry's poses), "coasted" (by the last velocity, where those do not tell), "set_aside",
/// "full" (end points left out).
class PointMap final : public MapModule {
 public:
  void describe(Ports& ports) override;
  void configure(Settings& settings) override;

  void set(Motion motion);
  void set(const FilterPose& pose);
  void set(LaserScan scan);

  /// Takes the next scan that is due into the map.
  Status execute() override;

  /// Whether the last execute() took a scan; further ones may be due.
  bool isBusy() const override { return is_busy_; }
  const std::vector<MapPoint>& points() const { return points_.points(); }
  /// Grows whenever points() tells something else.
  std::uint64_t revision() const { return revision_; }
  /// The stamp of the last scan taken.
  Stamp stamp() const { return stamp_; }
  std::optional<Stamp> lastMotion() const { return collator_.lastMotion(); }
  std::optional<Stamp> lastPose() const { return collator_.lastPose(); }
  Counters counters() const override;
  std::uint64_t dropped() const override;
  Figures figures() const override;
  std::string sentence() const override {
    return "also a map of points where a laser's beams end, to look at";
  }
  /// Writes `points.pcd`.
  void save(const std::string& folder) const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(gap_, collator_, points_, counters_, fault_, revision_, stamp_);
    if constexpr (Archive::kReads)
      fusion_->restoreState(archive);
    else
      fusion_->saveState(archive);
  }

 private:
  void begin();
  Status fuse(const LaserScan& scan, const Pose2& T_map_base);
  /// @return the end points that found no room
  std::uint64_t fuse(const LaserFan& fan, const Pose2& T_map_base);

  PointMapConfig config_;
  std::unique_ptr<FusionPolicy> fusion_;
  MotionGap gap_;
  PoseCollator collator_;
  PointSet points_;
  Counters counters_;
  std::string fault_;  ///< of an input since the last execute()
  std::uint64_t revision_ = 0;
  Stamp stamp_;
  bool is_busy_ = false;
};

}  // namespace slam::point_map
