// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/status.hpp"
#include "slam_core/common/time.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"
#include "slam_core/scan_matching/usual_fit.hpp"

namespace slam::scan_matching {

/// Whether the robot is where it takes itself to be, by a sequential test on how much of each scan
/// contradicts the map: the logarithm of the likelihood of "lost" over that of "right" is summed
/// over the scans and never falls below zero (CUSUM, Page 1954). Between two false alarms of a
/// threshold h there are at least e^h independent scans in the mean (Lorden 1971), so that the
/// threshold follows from how seldom a false alarm may come. The bound holds for a known model of
/// "right": here that is learnt (UsualFit), and what a jump adds is outside of it, too.
///
/// Scans that follow one another closely see the same and err alike: the weight of a scan grows
/// with the way, the turn and the time since the last one, up to 1. The sum never exceeds 2 h. An
/// alarm ends when it is back at zero, or with a new place.
class ScanDoubt {
 public:
  /// @param lost_share of the ends in known cells; a scan of which more contradicts the map does
  /// not go into it @param false_alarm_hours mean time between two false alarms, of a robot under
  /// way [h] @param map_is_fixed the map stays as it is; then scans that fit nothing speak for
  /// "lost"
  explicit ScanDoubt(double lost_share = 0.5, double false_alarm_hours = 1000.0,
                     bool map_is_fixed = false);

  /// To be called for each scan, before it goes into the map.
  void judge(const Match& match, Stamp stamp);
  /// Whether the last scan may go into the map. While the robot is lost or nearly so, one that
  /// rather speaks for that may not: the map would be drawn anew around the wrong place.
  bool admits() const;
  bool isLost() const { return lost_since_.has_value(); }
  /// The scan with which the doubt began that led to the alarm.
  const std::optional<Stamp>& lostSince() const { return lost_since_; }
  /// An alarm while the robot is lost, and a warning where the last scan was found far from where
  /// motion led.
  Status status() const;

  /// The sum relative to the threshold: 1 and more raises an alarm.
  double statistic() const { return sum_ / threshold_; }
  /// Between the scan with which the doubt began and the last one, while the robot is lost.
  Duration lostFor() const { return lost_since_ ? stamp_ - *lost_since_ : Duration::zero(); }
  /// Of the last scan.
  const Agreement& agreement() const { return agreement_; }
  /// A new place or map: what was seen before says nothing of it.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(usual_, sum_, evidence_, began_, lost_since_, pose_, jumped_, stamp_, agreement_);
  }

 private:
  /// Of the last scan, in independent ones; 1 at most.
  double weightOf(const Pose2& pose, Stamp stamp) const;
  double evidenceOf(const Match& match) const;
  void add(double evidence, Stamp stamp);

  double lost_share_, threshold_;
  bool map_is_fixed_;
  UsualFit usual_;
  double sum_ = 0.0;
  double evidence_ = 0.0;  ///< of the last scan
  Stamp began_;            ///< the sum was last at zero before this scan
  std::optional<Stamp> lost_since_;
  std::optional<Pose2> pose_;    ///< of the last scan
  std::optional<Pose2> jumped_;  ///< of the last scan, seen from where motion led
  Stamp stamp_;
  Agreement agreement_;
};

}  // namespace slam::scan_matching
