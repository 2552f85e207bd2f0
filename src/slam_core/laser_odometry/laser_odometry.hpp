// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/laser_odometry/laser_odometry_config.hpp"
#include "slam_core/laser_odometry/local_map.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/turn.hpp"
#include "slam_core/scan_matching/scan_tracker.hpp"

namespace slam::laser_odometry {

/// The motion of a robot from a laser: each scan is matched with what was seen on the last metres
/// of the way (Kohlbrecher et al. 2011). Every scan after the first yields a motion. Where a scan
/// fits nothing the last velocity is assumed to hold, with a standard deviation of max_speed dt,
/// or the motion source is asked; where a turn source knows the turn, that is taken.
///
/// Counted: "unmatched" scans, that fit nothing; of them "contradicting" ones, of which most
/// contradicts the map; "searched" ones, that a search in a window has found; "late", "stamp_jump";
/// "slips", where the scans contradict what the motion source reported; "maps" that were started
/// over.
class LaserOdometry final : public OdometrySource {
 public:
  /// Tells the motion between two stamps from another source; nothing where it does not cover them.
  using MotionSource = std::function<std::optional<Motion>(Stamp start, Stamp end)>;

  void configure(const LaserOdometryConfig& config, const scan_matching::MatcherConfig& matcher);
  void configure(Settings& settings) override;
  /// That says where to look, and how far the robot went where scans tell nothing.
  void setMotionSource(MotionSource source) { source_ = std::move(source); }
  /// The source says where to look, and how the robot turned where scans tell nothing.
  void setTurnSource(TurnSource source) { turn_source_ = std::move(source); }
  /// Whether the last two scans showed where the robot is.
  bool isMeasured() const { return is_measured_; }

  void describe(Ports& ports) override;
  void set(const LaserScan& scan) { input_ = scan; }
  Status execute() override;
  const std::optional<Motion>& motion() const override { return motion_; }
  std::string name() const override { return "laser"; }
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  void goOnLive() override { reset(); }
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(tracker_, trigger_, input_, last_, last_sure_, ahead_, agreement_, is_sure_,
            is_measured_, has_turn_, has_slipped_, motion_, next_sequence_, counters_, *map_);
  }

 private:
  bool isLate(Stamp stamp);
  /// Whether the scan tells where the robot is.
  bool judge(const scan_matching::Match& found, bool is_told);
  /// It holds what other sensors have measured on the way to a scan.
  struct Known {
    std::optional<Motion> motion;
    std::optional<Turn> turn;
  };
  Known knownOf(Stamp stamp) const;
  Motion motionTo(Stamp stamp, const Pose2& before, const Known& known);
  void learn(const scan_matching::ScanLevels& scan, Stamp stamp);
  Status explain() const;

  LaserOdometryConfig config_;
  double spacing_ = 0.0;
  MotionSource source_;
  TurnSource turn_source_;
  std::optional<LocalMap> map_;
  scan_matching::LevelModels models_;
  scan_matching::ScanTracker tracker_;
  scan_matching::InsertionTrigger trigger_{0.0, 0.0};
  std::optional<LaserScan> input_;
  std::optional<Stamp> last_, last_sure_;  ///< scan; scan that showed where the robot is
  std::optional<Stamp> ahead_;          ///< of a scan whose stamp jumped, until another confirms it
  scan_matching::Agreement agreement_;  ///< of the last scan
  bool is_sure_ = false;                ///< the last scan showed where the robot is
  bool is_measured_ = false;            ///< and so did the one before it
  bool has_turn_ = false;               ///< the turn source knew the way to the last scan
  bool has_slipped_ = false;            ///< on the way to the last scan
  std::optional<Motion> motion_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::laser_odometry
