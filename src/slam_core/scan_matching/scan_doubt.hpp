// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/status.hpp"
#include "slam_core/common/time.hpp"
#include "slam_core/scan_matching/scan_to_map_matcher.hpp"
#include "slam_core/scan_matching/usual_fit.hpp"

namespace slam::scan_matching {

/// Tests whether the robot is at its estimated pose, by a sequential test on how much of each scan
/// contradicts the map. The log-likelihood ratio of "lost" to "right" is summed over the scans and
/// never falls below zero (CUSUM, Page 1954). With a threshold h there are on average at least e^h
/// independent scans between two false alarms (Lorden 1971), so that the threshold follows from the
/// permitted rate of false alarms. This bound holds for a known model of "right". Here the model is
/// learnt (UsualFit), and the evidence of a jump is not covered by it either.
///
/// Scans in quick succession see the same and have the same errors. So the weight of a scan grows
/// with the distance, the turn and the time since the last one, up to 1. The sum never exceeds 2 h.
/// A robot that may be anywhere, since motion was missing for too long, is lost at once.
/// An alarm ends when the sum is back at zero, or when the robot is put at a new place. A scan of
/// which most ends lie where the map knows nothing does not lower the sum of a lost robot.
class ScanDoubt {
 public:
  /// @param lost_share share of the ends in known cells; a scan of which more contradicts the map
  /// is not added to it
  /// @param false_alarm_hours mean time between two false alarms of a moving robot [h]
  /// @param map_is_fixed the map does not change; then scans that fit nothing are evidence for
  /// "lost"
  explicit ScanDoubt(double lost_share = 0.5, double false_alarm_hours = 1000.0,
                     bool map_is_fixed = false);

  /// To be called for each scan, before it is added to the map.
  void judge(const Match& match, Stamp stamp);
  /// Returns whether the last scan may be added to the map. No scan is added while the robot is
  /// lost, and none that is evidence for "lost" while it is nearly so. Otherwise the map would be
  /// drawn again around the wrong place, and later scans would fit there.
  bool admits() const;
  bool isLost() const { return lost_since_.has_value(); }
  /// The stamp of the scan with which the doubt that led to the alarm began.
  const std::optional<Stamp>& lostSince() const { return lost_since_; }
  /// An alarm while the robot is lost, and a warning if the last scan was found far from the
  /// predicted pose.
  Status status() const;

  /// The sum relative to the threshold: 1 or more raises an alarm.
  double statistic() const { return sum_ / threshold_; }
  /// The time between the scan with which the doubt began and the last one; 0 while the robot is
  /// not lost.
  Duration lostFor() const { return lost_since_ ? stamp_ - *lost_since_ : Duration::zero(); }
  /// Of the last scan.
  const Agreement& agreement() const { return agreement_; }
  /// Whether the last scan corrected the pose: it determined the pose, and may be added to the map.
  friend bool hasCorrected(const ScanDoubt& doubt) {
    return doubt.is_determined_ && doubt.admits();
  }
  /// To be called for a new place or map: earlier scans say nothing about it.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(usual_, sum_, evidence_, began_, lost_since_, pose_, jumped_, is_anywhere_,
            is_determined_, stamp_, agreement_);
  }

 private:
  /// The weight of the last scan, in independent scans; 1 at most.
  double weightOf(const Pose2& pose, Stamp stamp) const;
  double evidenceOf(const Match& match) const;
  void add(double evidence, Stamp stamp);
  void beLost(Stamp stamp);

  double lost_share_, threshold_;
  bool map_is_fixed_;
  UsualFit usual_;
  double sum_ = 0.0;
  double evidence_ = 0.0;  ///< of the last scan
  Stamp began_;            ///< the sum was last at zero before this scan
  std::optional<Stamp> lost_since_;
  std::optional<Pose2> pose_;    ///< of the last scan
  std::optional<Pose2> jumped_;  ///< of the last scan, relative to the predicted pose
  bool is_anywhere_ = false;     ///< at the last scan the robot might be anywhere around
  bool is_determined_ = false;   ///< the pose, by the last scan
  Stamp stamp_;
  Agreement agreement_;
};

}  // namespace slam::scan_matching
