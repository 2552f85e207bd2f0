// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>
#include <string>

#include "slam_core/common/collator.hpp"
#include "slam_core/contract/gate.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Joins the scans of two lasers, each with its mount and its stamps: one scan for each scan of the
/// front laser, with the scan of the rear laser that is nearest in time. Odometry says how the
/// robot moved between the two stamps, so that the joined scan has the front scan's stamp; each
/// beam keeps its own laser as its origin. The nearest scan may be one before or after: where
/// odometry has a bias, as of wheels of different size, a rear scan that always came first would
/// turn the map.
///
/// Scans are ordered by a collator, so that the order of arrival does not matter: a scan waits
/// until motion covers it and the other laser has passed its stamp, but not for a laser that is
/// silent for kPatience of the product's `source_timeout`. That is less than all of it, so that the
/// back-end does not take both lasers for silent. While the front laser is silent, the scans of the
/// rear one come out alone.
///
/// Call order as of every gate: set an input, execute() until isBusy() is false.
/// Counted: the collator's reasons; "front_alone" and "rear_alone" (scans that came out without the
/// other laser's), "rear_left_out" (a scan of the rear laser that is nearest to no front scan, or
/// to which no motion leads), "same_mount" (scans of a rear laser that is said to be where the
/// front one is; they are left out as well), "invalid_motion".
class JoinedScanGate final : public Gate {
 public:
  /// The gate and its output have this name.
  static constexpr const char* kName = "joined_scan";
  static constexpr double kPatience = 0.75;

  std::string name() const override { return kName; }
  void describe(Ports& ports) override;
  /// A fresh start.
  void configure(Duration source_timeout);
  /// @throw ConfigError
  void configure(Settings& settings) override;

  void setFront(const LaserScan& scan) { push(kFront, scan); }
  void setRear(const LaserScan& scan) { push(kRear, scan); }
  void set(const Motion& motion);

  /// Lets the next scan out that is due, with a warning where one laser is silent.
  Status execute() override;
  bool isBusy() const override { return scan_.has_value(); }

  const std::optional<LaserScan>& scan() const { return scan_; }
  Counters counters() const override;
  Counters held() const override;
  std::uint64_t dropped() const override;
  void reset() override;

  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;
  template <class Archive>
  void persist(Archive& archive) {
    collator_.persist(archive, {Arrival(), Arrival()});
    archive(front_, rear_, start_, last_front_, last_rear_, front_interval_, rear_interval_, out_,
            sequence_, scan_, counters_);
  }

 private:
  /// If two scans have one stamp, the rear one is taken first, so that both are joined.
  enum Source : std::size_t { kRear, kFront };
  struct Arrival {
    bool is_rear = false;
    LaserScan scan;

    template <class Archive>
    void persist(Archive& archive) {
      archive(is_rear, scan);
    }
  };
  using Scans = Collator<Motion, Arrival>;
  /// This scan waits; the robot's way since its stamp is followed.
  struct Waiting {
    LaserScan scan;
    Pose2 T_then_now;
    Stamp now;  ///< up to where the way is known
    /// A front scan has here the last rear scan before it, seen from its own pose.
    std::optional<LaserFan> before;
    Duration apart{};  ///< so far is that scan's stamp from this one's

    template <class Archive>
    void persist(Archive& archive) {
      archive(scan, T_then_now, now, before, apart);
    }
  };

  void push(Source source, const LaserScan& scan);
  /// A warning where scans wait for motion that does not come.
  Status starvation() const;
  Status take(const Scans::Step& step);
  void restart();
  Status takeRear(const LaserScan& scan);
  Status takeFront(const LaserScan& scan);
  /// The rear laser has this scan's mount, which cannot be true.
  Status leaveOutRear(const LaserScan& scan);
  /// Says whether the front scan that waits is to be joined with this rear scan.
  bool isNearest(const LaserScan& rear) const;
  /// Takes the rear scan that waits, seen from the robot's pose now.
  std::optional<LaserFan> fanBefore(Stamp now);
  /// The front scan that waits need not wait any more.
  void letOutFront();
  void letOutFront(LaserScan scan, const std::optional<LaserFan>& rear);
  void letOut(LaserScan scan);

  Duration patience_ = std::chrono::seconds(1);
  Scans collator_{2};
  std::optional<Waiting> front_;  ///< waits for the next rear scan, which may be nearer
  std::optional<Waiting> rear_;   ///< waits for a front scan
  std::optional<Stamp> start_;    ///< of the first step
  std::optional<Stamp> last_front_, last_rear_;
  Duration front_interval_{}, rear_interval_{};  ///< between the last two scans; 0: unknown
  std::deque<LaserScan> out_;                    ///< these are joined
  std::uint64_t sequence_ = 0;
  std::optional<LaserScan> scan_;
  Counters counters_;
};

}  // namespace slam
